// Gathers the light of one tile of a picture.
#pragma once

#include <Eigen/Core>
#include <array>
#include <bitset>
#include <cstdint>

#include "player/render/camera_rays.h"
#include "player/render/lighting.h"
#include "player/render/quality.h"
#include "player/render/ray_batch.h"
#include "player/render/render_scene.h"
#include "player/render/sampling.h"

namespace ribbon {

inline constexpr int tile_side = 16;  // pixels
inline constexpr int tile_pixels = tile_side * tile_side;

// Sums over the samples of a pixel, and what they are good for.
struct PixelSums {
  Eigen::Array4f direct = Eigen::Array4f::Zero();    // backdrop, and the sun's light returned; the
                                                     // fourth: samples that saw the ground
  Eigen::Array4f albedo = Eigen::Array4f::Zero();    // the fourth: samples that saw the ribbon
  Eigen::Array4f sky = Eigen::Array4f::Zero();       // the fourth: samples that saw the obstacle
  Eigen::Array4f shown = Eigen::Array4f::Zero();     // the fourth: all samples
  Eigen::Array4f normal = Eigen::Array4f::Zero();    // only where the sky is to be smoothed
  Eigen::Array4f position = Eigen::Array4f::Zero();  // likewise; the fourth: squared luminance
};

// What all tiles of a picture share.
struct Setting {
  const RenderScene& scene;
  const CameraRays& rays;
  const SamplePatterns& patterns;  // as many as quality.most_samples
  const Quality& quality;
  const Lighting& lighting;
  const Backdrop& backdrop;
  PictureSize size;
};

// Samples are shaded in batches, so that each kind of ray is traced in full packets.
class TilePainter {
 public:
  explicit TilePainter(const Setting& setting);

  // Takes the samples of the pixels from (left, top) on, tile_side rows of tile_side; those outside
  // the picture get none.
  void paint(int left, int top);

  [[nodiscard]] const PixelSums& pixel(int column, int row) const {
    return sums_[static_cast<std::size_t>(row) * tile_side + column];
  }
  // Estimated standard error of that pixel, in 8-bit levels. Needs two samples at least.
  [[nodiscard]] float error(int column, int row) const;

 private:
  struct Sample {
    std::uint16_t pixel;  // of the tile
    std::uint16_t number;
  };
  void set_keys();
  void sample_wanting(int first, int end);
  bool find_wanting(int taken);
  void add(const Sample& sample);
  void finish_batch();
  void sort_hits();
  void add_sunlight(Pattern pattern, const SurfaceBatch& surface, const Lanes<Sample>& samples,
                    VectorLanes& light);
  void add_skylight(Pattern pattern, const SurfaceBatch& surface, const Lanes<Sample>& samples,
                    float returned, VectorLanes& light);
  void add_bounced_skylight(VectorLanes& light);
  void look(Pattern pattern, const Lanes<Sample>& samples, std::size_t count);
  void ask_sky(Pattern pattern, const SurfaceBatch& surface, const Lanes<Sample>& samples);
  void count_in(const Sample& sample, const Eigen::Array4f& shown);

  const Setting& s_;
  int left_ = 0;
  int top_ = 0;
  int width_ = 0;
  int height_ = 0;
  std::array<PixelSums, tile_pixels> sums_;
  std::bitset<tile_pixels> wanting_;

  std::array<std::array<std::array<std::uint32_t, 2>, tile_pixels>, pattern_count> keys_;

  Lanes<Sample> samples_;
  RayBatch rays_;
  Lanes<Hit> hits_;
  SurfaceBatch seen_;
  Lanes<Sample> seen_samples_;
  VectorLanes sunlight_;
  VectorLanes skylight_;
  Lanes<float> disc_x_;
  Lanes<float> disc_y_;
  VectorLanes towards_;
  RayBatch light_rays_;
  Lanes<std::uint16_t> asked_for_;  // the lane whose light each of light_rays_ asks for
  Lanes<float> free_;
  SurfaceBatch bounce_;
  Lanes<Sample> bounce_samples_;
  Lanes<std::uint16_t> bounce_of_;  // the lane that receives light from there
};

}  // namespace ribbon
