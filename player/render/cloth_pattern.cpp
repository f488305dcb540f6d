#include "player/render/cloth_pattern.h"

#include <cmath>

#include "parallel/vector_loop.h"
#include "player/render/lane_vector.h"

namespace ribbon {

namespace {

const Color indigo = from_srgb(0x1F4080);
const Color cream = from_srgb(0xEFE3C8);
const Color gold = from_srgb(0xC8963E);
const Color vermilion = from_srgb(0xC2452D);
const Color wine = from_srgb(0x8E2A20);

// Distances from the selvage, in ribbon widths.
constexpr float stripe_begin = 0.03F;
constexpr float stripe_end = 0.09F;
constexpr float pattern_begin = 0.13F;

// What stands below is a part of loops over many looks: nothing that a compiler would have to call,
// and no choice between two ways to go on.

// As std::floor, of numbers up to 2^22. Lanes that mean nothing may hold any others, which are no
// whole number that fits.
[[gnu::always_inline]] inline float rounded_down(float number) {
  constexpr float whole_from = 0x1.8p23F;
  const float whole = (number + whole_from) - whole_from;
  return number < whole ? whole - 1 : whole;
}

[[gnu::always_inline]] inline float larger(float a, float b) {
  return a < b ? b : a;
}
[[gnu::always_inline]] inline float smaller(float a, float b) {
  return b < a ? b : a;
}

// 0 below `border`, 1 above it, with a soft step of width `blur` between.
[[gnu::always_inline]] inline float step(float value, float border, float blur) {
  return smaller(larger((value - border) / blur + 0.5F, 0.0F), 1.0F);
}

[[gnu::always_inline]] inline float distance_to_selvage(float across) {
  return smaller(across, 1.0F - across);
}

// 1 on the stripe, 0 beside it.
[[gnu::always_inline]] inline float stripe(float selvage, float blur) {
  const float soft = larger(blur, 1e-6F);
  return step(selvage, stripe_begin, soft) - step(selvage, stripe_end, soft);
}

constexpr float rows_per_width = 4;

// Of a row's nearest disc.
[[gnu::always_inline]] inline float squared_distance(float row, float along, float across) {
  const float shift = row / 2 - rounded_down(row / 2);
  const float dx = across - shift - rounded_down(across - shift + 0.5F);
  const float dy = along - row / rows_per_width;
  return dx * dx + dy * dy;
}

// "Waves of the blue sea": discs as wide as the ribbon that overlap like roof tiles, each of
// concentric arcs, so that only fans are left, opening towards the ribbon's second end. Returns how
// much of the cream thread shows.
[[gnu::always_inline]] inline float waves(float along, float across, float blur) {
  constexpr float arcs = 3;
  constexpr float thread_begin = 0.74F;  // of each arc
  constexpr float mean = 0.325F;         // of the thread over all discs, summed up numerically
  // Arcs are a sixth of a width apart; from a look that spans one on, only their mean is seen.
  const float arcs_seen = blur * 2 * arcs;
  // A disc reaches half a width around its centre; of those that hold the point the first lies on
  // top. One of the first three does: what two neighbouring rows leave open the next one covers.
  const float row = -rounded_down((0.5F - along) * rows_per_width);
  const float first = squared_distance(row, along, across);
  const float second = squared_distance(row + 1, along, across);
  const float third = squared_distance(row + 2, along, across);
  const float on_top = first <= 0.25F ? first : second <= 0.25F ? second : third;
  const float radius = 2 * std::sqrt(on_top);
  const float arc = radius * arcs - rounded_down(radius * arcs);
  const float thread = step(arc, thread_begin, larger(0.1F, arcs_seen));
  const float seen = smaller(arcs_seen, 1.0F);
  return thread + (mean - thread) * seen * seen;
}

// How much of a colour lies on the ground: first the thread, over it the stripe.
struct Threads {
  float thread;
  float stripe;
};

[[gnu::always_inline]] inline Threads front_threads(float along, float across, float blur) {
  const float selvage = distance_to_selvage(across);
  const float patterned = step(selvage, pattern_begin, larger(blur, 1e-6F));
  return {patterned * waves(along, across, blur), stripe(selvage, blur)};
}

}  // namespace

Color cloth_front(float along, float across, float blur) {
  const Threads threads = front_threads(along, across, blur);
  const Color color = indigo + (cream - indigo) * threads.thread;
  return color + (gold - color) * threads.stripe;
}

Color cloth_back(float /*along*/, float across, float blur) {
  return vermilion + (wine - vermilion) * stripe(distance_to_selvage(across), blur);
}

void pattern_colors(const LookBatch& looks, std::size_t count, VectorLanes& colors,
                    std::size_t first) {
  vectorised([&]() RIBBON_INLINED {
    const LaneVector front = lane_vector(indigo);
    const LaneVector thread_on_front = lane_vector(cream - indigo);
    const LaneVector front_stripe = lane_vector(gold);
    const LaneVector back = lane_vector(vermilion);
    const LaneVector stripe_on_back = lane_vector(wine - vermilion);
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      const Threads threads = front_threads(looks.x[i], looks.y[i], looks.reach[i]);
      const LaneVector woven = front + threads.thread * thread_on_front;
      const LaneVector seen = looks.front[i] > 0 ? woven + threads.stripe * (front_stripe - woven)
                                                 : back + threads.stripe * stripe_on_back;
      set_lane(colors, first + i, seen);
    }
  });
}

}  // namespace ribbon
