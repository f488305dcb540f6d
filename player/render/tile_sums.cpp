#include "player/render/tile_sums.h"

#include "parallel/vector_loop.h"
#include "player/render/lane_vector.h"

namespace ribbon {

namespace {

[[gnu::always_inline]] inline float fourth_of(float same, std::size_t /*lane*/) {
  return same;
}
[[gnu::always_inline]] inline float fourth_of(const Lanes<float>& numbers, std::size_t lane) {
  return numbers[lane];
}

float& samples_of_body(Body body, SurfaceSums& sums) {
  if (body == Body::ribbon) return sums.albedo[3];
  return body == Body::obstacle ? sums.sky[3] : sums.direct[3];
}

}  // namespace

void TileSums::clear() {
  const Eigen::Array4f zero = Eigen::Array4f::Zero();
  shown_.fill(zero);
  if (smooth_sky_) surfaces_.fill({zero, zero, zero, zero, zero});
  if (is_adaptive_) squared_light_.fill(0);
}

void TileSums::add(const SeenBatch& seen) {
  VectorLanes direct;
  VectorLanes shown;
  Lanes<float> squared_light;  // only where it is asked for
  const std::size_t count = seen.surfaces.count;
  const LaneVector even_sky = lane_vector(Color::Constant(0.5F));
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      const LaneVector albedo = lane_of(seen.surfaces.albedo, i);
      const LaneVector returned = albedo * lane_of(seen.sunlight, i);
      // What smoothing takes away is no noise that takes samples.
      const LaneVector sky = smooth_sky_ ? even_sky : lane_of(seen.skylight, i);
      const LaneVector all = returned + albedo * sky;
      set_lane(shown, i, all);
      if (smooth_sky_) set_lane(direct, i, returned);
      if (is_adaptive_) squared_light[i] = luminance(all) * luminance(all);
    }
  });
  if (is_single_) {
    lay_together(shown, 1.0F, count);
    for (std::size_t i = 0; i < count; ++i) shown_[seen.places[i]] = together_[i];
    return;
  }
  find_runs(seen);
  if (is_adaptive_) {
    add_runs(seen, shown, squared_light,
             [this](std::size_t place, float samples, Eigen::Array4f sum) {
               squared_light_[place] += sum[3];
               sum[3] = samples;
               shown_[place] += sum;
             });
  } else {
    add_runs(seen, shown, 1.0F,
             [this](std::size_t place, float, const Eigen::Array4f& sum) { shown_[place] += sum; });
  }
  if (smooth_sky_) add_surfaces(seen, direct);
}

void TileSums::find_runs(const SeenBatch& seen) {
  const std::size_t count = seen.surfaces.count;
  const auto& places = seen.places;
  const auto& body = seen.surfaces.body;
  Lanes<std::uint8_t> begins;
  vectorised([&]() RIBBON_INLINED {
    RIBBON_EACH_LANE
    for (std::size_t i = 1; i < count; ++i)
      begins[i] = places[i] != places[i - 1] || body[i] != body[i - 1] ? 1 : 0;
  });
  begins[0] = 1;
  list_marked(begins.data(), 1, count, runs_);
}

// The numbers of each lane become those of together_, with `fourth` behind them.
template <class Fourth>
void TileSums::lay_together(const VectorLanes& numbers, const Fourth& fourth, std::size_t count) {
  float* const together = together_.front().data();
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      together[4 * i] = numbers.x[i];
      together[4 * i + 1] = numbers.y[i];
      together[4 * i + 2] = numbers.z[i];
      together[4 * i + 3] = fourth_of(fourth, i);
    }
  });
}

// Calls take(place of the pixel, number of lanes, sum of their numbers) for each run, where the
// fourth number of each lane is `fourth`.
template <class Fourth, class Take>
void TileSums::add_runs(const SeenBatch& seen, const VectorLanes& numbers, const Fourth& fourth,
                        const Take& take) {
  lay_together(numbers, fourth, seen.surfaces.count);
  runs_.lanes[runs_.count] = static_cast<std::uint16_t>(seen.surfaces.count);
  for (std::size_t r = 0; r < runs_.count; ++r) {
    const std::size_t begin = runs_.lanes[r];
    const std::size_t end = runs_.lanes[r + 1];
    Eigen::Array4f of_run = together_[begin];
    for (std::size_t i = begin + 1; i < end; ++i) of_run += together_[i];
    take(seen.places[begin], static_cast<float>(end - begin), of_run);
  }
}

void TileSums::add_surfaces(const SeenBatch& seen, const VectorLanes& direct) {
  constexpr float none = 0;
  const auto add = [&](const VectorLanes& numbers, Eigen::Array4f SurfaceSums::*to) {
    add_runs(seen, numbers, none, [this, to](std::size_t place, float, const Eigen::Array4f& sum) {
      surfaces_[place].*to += sum;
    });
  };
  add(direct, &SurfaceSums::direct);
  add(seen.surfaces.albedo, &SurfaceSums::albedo);
  add(seen.surfaces.normal, &SurfaceSums::normal);
  add(seen.surfaces.position, &SurfaceSums::position);
  add_runs(seen, seen.skylight, none,
           [&](std::size_t place, float samples, const Eigen::Array4f& sum) {
             if (!seen.has_skylight[place]) return;
             surfaces_[place].sky += sum;
             surfaces_[place].normal[3] += samples;
           });
  for (std::size_t r = 0; r < runs_.count; ++r) {
    const std::size_t begin = runs_.lanes[r];
    samples_of_body(seen.surfaces.body[begin], surfaces_[seen.places[begin]]) +=
        static_cast<float>(runs_.lanes[r + 1] - begin);
  }
}

}  // namespace ribbon
