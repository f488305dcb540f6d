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

// What stands for the light of the sky where that is to be smoothed: smoothing takes away its
// noise.
inline constexpr float even_sky = 0.5F;

// Sums over the samples of a pixel that tell which surfaces it shows and in which light.
struct SurfaceSums {
  Eigen::Array4f albedo;    // the fourth: samples that saw the ribbon
  Eigen::Array4f sky;       // the fourth: samples that saw the obstacle
  Eigen::Array4f normal;    // of the first samples; the fourth: samples behind `sky`
  Eigen::Array4f position;  // of the first samples; the fourth: samples that saw the ground

  // Backdrop, and the sun's light returned, of what the pixel shows.
  [[nodiscard]] Eigen::Array3f direct(const Eigen::Array4f& shown) const {
    return (shown - even_sky * albedo).head<3>();
  }
  // `samples`: all of the pixel.
  [[nodiscard]] bool saw_one_surface(float samples) const {
    return position[3] == samples || albedo[3] == samples || sky[3] == samples;
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
  // From now on samples tell no more of normals and positions.
  void surfaces_are_known() { knows_surfaces_ = true; }
  void add_backdrop(std::size_t place, const Eigen::Array4f& backdrop) {
    const Eigen::Array4f counted = backdrop + Eigen::Array4f(0, 0, 0, 1);
    if (is_single_) {
      shown_[place] = counted;
      return;
    }
    shown_[place] += counted;
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
  // What is added up: the first always, the next two where the sky is to be smoothed, the last
  // until surfaces are known.
  enum Summed : std::size_t { of_shown, of_albedo, of_sky, of_normal, of_position, summed_count };

  void find_runs(const SeenBatch& seen);
  template <class Fourth>
  static void lay_together(const VectorLanes& numbers, const Fourth& fourth, std::size_t count,
                           Lanes<Eigen::Array4f>& together);
  template <std::size_t kinds>
  void add_runs(const SeenBatch& seen);

  bool smooth_sky_;
  bool is_adaptive_;
  bool knows_surfaces_ = false;
  bool is_single_;  // each pixel has one sample: nothing is added up
  std::array<Eigen::Array4f, tile_pixels> shown_;
  std::array<SurfaceSums, tile_pixels> surfaces_;
  std::array<float, tile_pixels> squared_light_;
  std::array<Lanes<Eigen::Array4f>, summed_count>
      together_;      // numbers of the lanes, those of each together
  MarkedLanes runs_;  // the first lane of each run of one pixel and one body; then the end
};

}  // namespace ribbon
