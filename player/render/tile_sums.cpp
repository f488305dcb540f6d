#include "player/render/tile_sums.h"

#include "parallel/vector_loop.h"
#include "player/render/lane_vector.h"

namespace ribbon {

namespace {

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

void TileSums::add_backdrop(std::size_t place, const Eigen::Array4f& backdrop) {
  shown_[place] += backdrop;
  shown_[place][3] += 1;
  if (smooth_sky_) surfaces_[place].direct += backdrop;
  if (!is_adaptive_) return;
  const float light = luminance({backdrop[0], backdrop[1], backdrop[2]});
  squared_light_[place] += light * light;
}

void TileSums::add(const SeenBatch& seen) {
  VectorLanes direct;
  VectorLanes shown;
  Lanes<float> squared_light;
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
  find_runs(seen);
  add_runs(seen, shown, 1, [this](std::size_t place) { return &shown_[place]; });
  if (is_adaptive_)
    for (std::size_t i = 0; i < count; ++i) squared_light_[seen.places[i]] += squared_light[i];
  if (smooth_sky_) add_surfaces(seen, direct);
}

void TileSums::find_runs(const SeenBatch& seen) {
  runs_.count = 0;
  for (std::size_t i = 0; i < seen.surfaces.count; ++i)
    runs_.add_if(i, i == 0 || seen.places[i] != seen.places[i - 1] ||
                        seen.surfaces.body[i] != seen.surfaces.body[i - 1]);
}

// Adds numbers of the lanes, and for each lane `fourth`, to the sums that sum_at(place of the
// pixel) points to, if it does.
template <class SumAt>
void TileSums::add_runs(const SeenBatch& seen, const VectorLanes& numbers, float fourth,
                        const SumAt& sum_at) {
  const std::size_t count = seen.surfaces.count;
  float* const together = together_.front().data();
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      together[4 * i] = numbers.x[i];
      together[4 * i + 1] = numbers.y[i];
      together[4 * i + 2] = numbers.z[i];
      together[4 * i + 3] = fourth;
    }
  });
  for (std::size_t r = 0; r < runs_.count; ++r) {
    const std::size_t begin = runs_.lanes[r];
    const std::size_t end = r + 1 < runs_.count ? runs_.lanes[r + 1] : count;
    Eigen::Array4f* const sum = sum_at(seen.places[begin]);
    if (sum == nullptr) continue;
    Eigen::Array4f of_run = together_[begin];
    for (std::size_t i = begin + 1; i < end; ++i) of_run += together_[i];
    *sum += of_run;
  }
}

void TileSums::add_surfaces(const SeenBatch& seen, const VectorLanes& direct) {
  const auto at = [this](Eigen::Array4f SurfaceSums::*sum) {
    return [this, sum](std::size_t place) { return &(surfaces_[place].*sum); };
  };
  add_runs(seen, direct, 0, at(&SurfaceSums::direct));
  add_runs(seen, seen.surfaces.albedo, 0, at(&SurfaceSums::albedo));
  add_runs(seen, seen.surfaces.normal, 0, at(&SurfaceSums::normal));
  add_runs(seen, seen.surfaces.position, 0, at(&SurfaceSums::position));
  add_runs(seen, seen.skylight, 0, [&](std::size_t place) {
    return seen.has_skylight[place] ? &surfaces_[place].sky : nullptr;
  });
  for (std::size_t i = 0; i < seen.surfaces.count; ++i) {
    const std::size_t place = seen.places[i];
    samples_of_body(seen.surfaces.body[i], surfaces_[place]) += 1;
    surfaces_[place].normal[3] += seen.has_skylight[place] ? 1.0F : 0.0F;
  }
}

}  // namespace ribbon
