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
  return body == Body::obstacle ? sums.sky[3] : sums.position[3];
}

}  // namespace

void TileSums::clear() {
  const Eigen::Array4f zero = Eigen::Array4f::Zero();
  shown_.fill(zero);
  if (smooth_sky_) surfaces_.fill({zero, zero, zero, zero});
  knows_surfaces_ = false;
  if (is_adaptive_) squared_light_.fill(0);
}

void TileSums::add(const SeenBatch& seen) {
  VectorLanes shown;
  Lanes<float> squared_light;
  const std::size_t count = seen.surfaces.count;
  // What smoothing takes away is no noise that takes samples.
  const float sky_counts = smooth_sky_ ? 0.0F : 1.0F;
  const float even = smooth_sky_ ? even_sky : 0.0F;
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      const LaneVector albedo = lane_of(seen.surfaces.albedo, i);
      const LaneVector returned = albedo * lane_of(seen.sunlight, i);
      const LaneVector skylight = lane_of(seen.skylight, i);
      const LaneVector sky = {even + sky_counts * skylight.x, even + sky_counts * skylight.y,
                              even + sky_counts * skylight.z};
      const LaneVector all = returned + albedo * sky;
      set_lane(shown, i, all);
      squared_light[i] = luminance(all) * luminance(all);
    }
  });
  if (is_single_) {
    lay_together(shown, 1.0F, count, together_[of_shown]);
    for (std::size_t i = 0; i < count; ++i) shown_[seen.places[i]] = together_[of_shown][i];
    return;
  }
  find_runs(seen);
  if (is_adaptive_)
    lay_together(shown, squared_light, count, together_[of_shown]);
  else
    lay_together(shown, 1.0F, count, together_[of_shown]);
  if (!smooth_sky_) return add_runs<of_shown + 1>(seen);
  const auto lay = [&](Summed what, const VectorLanes& numbers) {
    lay_together(numbers, 0.0F, count, together_[what]);
  };
  lay(of_albedo, seen.surfaces.albedo);
  lay(of_sky, seen.skylight);
  if (knows_surfaces_) return add_runs<of_sky + 1>(seen);
  lay(of_normal, seen.surfaces.normal);
  lay(of_position, seen.surfaces.position);
  add_runs<summed_count>(seen);
}

void TileSums::find_runs(const SeenBatch& seen) {
  const std::size_t count = seen.surfaces.count;
  Lanes<std::uint8_t> begins;
  vectorised([&]() RIBBON_INLINED {
    // Bytes that are stored may lie anywhere, as compilers see it.
    const std::uint32_t* const places = seen.places.data();
    const Body* const body = seen.surfaces.body.data();
    std::uint8_t* const marks = begins.data();
    const std::size_t end = count;
    RIBBON_EACH_LANE
    for (std::size_t i = 1; i < end; ++i)
      marks[i] = ((places[i] != places[i - 1]) | (body[i] != body[i - 1])) ? 1 : 0;
  });
  begins[0] = 1;
  list_marked(begins.data(), 1, count, runs_);
}

// The numbers of each lane become those of `together`, with `fourth` behind them.
template <class Fourth>
void TileSums::lay_together(const VectorLanes& numbers, const Fourth& fourth, std::size_t count,
                            Lanes<Eigen::Array4f>& together) {
  float* const to = together.front().data();
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      to[4 * i] = numbers.x[i];
      to[4 * i + 1] = numbers.y[i];
      to[4 * i + 2] = numbers.z[i];
      to[4 * i + 3] = fourth_of(fourth, i);
    }
  });
}

// Adds the first `kinds` of what is summed, all in one round: where runs end nobody can foretell.
template <std::size_t kinds>
void TileSums::add_runs(const SeenBatch& seen) {
  runs_.lanes[runs_.count] = static_cast<std::uint16_t>(seen.surfaces.count);
  for (std::size_t r = 0; r < runs_.count; ++r) {
    const std::size_t begin = runs_.lanes[r];
    const std::size_t end = runs_.lanes[r + 1];
    std::array<Eigen::Array4f, kinds> sums;
    for (std::size_t k = 0; k < kinds; ++k) sums[k] = together_[k][begin];
    for (std::size_t i = begin + 1; i < end; ++i)
      for (std::size_t k = 0; k < kinds; ++k) sums[k] += together_[k][i];
    const auto samples = static_cast<float>(end - begin);
    const std::size_t place = seen.places[begin];
    if (is_adaptive_) {
      squared_light_[place] += sums[of_shown][3];
      sums[of_shown][3] = samples;
    }
    shown_[place] += sums[of_shown];
    if constexpr (kinds > of_sky) {
      SurfaceSums& of_pixel = surfaces_[place];
      of_pixel.albedo += sums[of_albedo];
      if constexpr (kinds == summed_count) {
        of_pixel.normal += sums[of_normal];
        of_pixel.position += sums[of_position];
      }
      if (seen.has_skylight[place]) {
        of_pixel.sky += sums[of_sky];
        of_pixel.normal[3] += samples;
      }
      samples_of_body(seen.surfaces.body[begin], of_pixel) += samples;
    }
  }
}

}  // namespace ribbon
