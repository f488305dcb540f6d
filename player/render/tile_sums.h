// What samples told about each pixel of a tile.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "player/render/lane_vector.h"
#include "player/render/quality.h"
#include "player/render/ray_batch.h"
#include "player/render/surface_points.h"
#include "player/render/tile_noise.h"

namespace ribbon {

// Sums over the samples of a pixel that tell which surfaces it shows and in which light.
struct SurfaceSums {
  Eigen::Array4f direct;  // backdrop, and the sun's light returned; the fourth: samples that saw
                          // the ground
  Eigen::Array4f albedo;  // the fourth: samples that saw the ribbon
  Eigen::Array4f sky;     // the fourth: samples that saw the obstacle
  Eigen::Array4f normal;  // the fourth: samples behind `sky`
  Eigen::Array4f position;

  // `samples`: all of the pixel.
  [[nodiscard]] bool saw_one_surface(float samples) const {
    return direct[3] == samples || albedo[3] == samples || sky[3] == samples;
  }
};

// Surfaces that samples saw, in which light, and for which pixels. Those of one pixel that saw the
// same body lie side by side.
struct SeenBatch {
  const SurfaceBatch& surfaces;
  const Lanes<std::uint32_t>& places;  // in the tile
  const VectorLanes& sunlight;
  const VectorLanes& skylight;
  const std::array<bool, tile_pixels>& has_skylight;  // of each pixel of the tile
};

// Keeps what `quality` needs, so that little memory is gone through.
class TileSums {
 public:
  explicit TileSums(const Quality& quality)
      : smooth_sky_(quality.smooth_sky),
        is_adaptive_(quality.is_adaptive()),
        is_single_(quality.samples == 1 && !smooth_sky_ && !is_adaptive_) {}

  void clear();
  void add_backdrop(std::size_t place, const Eigen::Array4f& backdrop) {
    const Eigen::Array4f counted = backdrop + Eigen::Array4f(0, 0, 0, 1);
    if (is_single_) {
      shown_[place] = counted;
      return;
    }
    shown_[place] += counted;
    if (smooth_sky_) surfaces_[place].direct += backdrop;
    if (!is_adaptive_) return;
    const float light = luminance(LaneVector{backdrop[0], backdrop[1], backdrop[2]});
    squared_light_[place] += light * light;
  }
  void add(const SeenBatch& seen);

  // Of a pixel's light; the fourth number counts samples.
  [[nodiscard]] const std::array<Eigen::Array4f, tile_pixels>& shown() const { return shown_; }
  // Only where the sky is to be smoothed.
  [[nodiscard]] const SurfaceSums& surface(std::size_t place) const { return surfaces_[place]; }
  // Of the luminance; only where pixels may get more samples than others.
  [[nodiscard]] const std::array<float, tile_pixels>& squared_light() const {
    return squared_light_;
  }

 private:
  // What is added up: the first always, the others where the sky is to be smoothed.
  enum Summed : std::size_t {
    of_shown,
    of_direct,
    of_albedo,
    of_sky,
    of_normal,
    of_position,
    summed_count
  };

  void find_runs(const SeenBatch& seen);
  template <class Fourth>
  static void lay_together(const VectorLanes& numbers, const Fourth& fourth, std::size_t count,
                           Lanes<Eigen::Array4f>& together);
  template <std::size_t kinds>
  void add_runs(const SeenBatch& seen);

  bool smooth_sky_;
  bool is_adaptive_;
  bool is_single_;  // each pixel has one sample: nothing is added up
  std::array<Eigen::Array4f, tile_pixels> shown_;
  std::array<SurfaceSums, tile_pixels> surfaces_;
  std::array<float, tile_pixels> squared_light_;
  std::array<Lanes<Eigen::Array4f>, summed_count>
      together_;   // numbers of the lanes, those of each together
  LaneList runs_;  // the first lane of each run of one pixel and one body; then the end
};

}  // namespace ribbon
