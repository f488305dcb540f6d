// Gathers the light of one tile of a picture.
#pragma once

#include <Eigen/Core>
#include <array>
#include <bitset>
#include <cstdint>

#include "player/render/backdrop_view.h"
#include "player/render/camera_rays.h"
#include "player/render/lighting.h"
#include "player/render/quality.h"
#include "player/render/ray_batch.h"
#include "player/render/render_scene.h"
#include "player/render/sampling.h"
#include "player/render/tile_noise.h"
#include "player/render/tile_sums.h"

namespace ribbon {

// What all tiles of a picture share.
struct Setting {
  const RenderScene& scene;
  const CameraRays& rays;
  const SamplePatterns& patterns;  // as many as quality.most_samples
  const Quality& quality;
  const Lighting& lighting;
  const BackdropView& backdrop;
  PictureSize size;
};

// Samples are shaded in batches, so that each kind of ray is traced in full packets.
class TilePainter {
 public:
  explicit TilePainter(const Setting& setting);

  // Takes the samples of the pixels from (left, top) on, tile_side rows of tile_side; those outside
  // the picture get none.
  void paint(int left, int top);

  // Sums over the samples of a pixel: of its light; the fourth number counts them.
  [[nodiscard]] const Eigen::Array4f& shown(int column, int row) const {
    return sums_.shown()[place_in_tile(column, row)];
  }
  [[nodiscard]] const SurfaceSums& surface(int column, int row) const {
    return sums_.surface(place_in_tile(column, row));
  }
  // Estimated error of the tile, in 8-bit levels; 0 where nobody asked, as all pixels get as many
  // samples.
  [[nodiscard]] float error() const { return s_.quality.is_adaptive() ? noise_.error() : 0; }

 private:
  // Which samples the lanes are.
  struct Samples {
    Lanes<std::uint32_t> place;   // of the pixel, in the tile
    Lanes<std::uint32_t> number;  // of the pixel's samples

    // Lanes from `first` on become those of `others` that are listed.
    void set(std::size_t first, const Samples& others, const MarkedLanes& list);
  };
  void sample_evenly(int taken, int more);
  void sample_whole_tile(std::uint32_t taken, std::uint32_t each);
  void sample_wanting(int first_samples);
  void sample_again(std::size_t place, int first_samples);
  [[nodiscard]] std::bitset<tile_pixels> worth_more() const;
  void finish_batch();
  void sort_hits();
  bool add_ground(std::size_t lane);
  void find_sunlight(Pattern pattern, const SurfaceBatch& surface, const Samples& samples,
                     VectorLanes& light);
  void add_skylight(Pattern pattern, const SurfaceBatch& surface, const Samples& samples,
                    float returned, VectorLanes& light);
  void add_bounced_skylight(VectorLanes& light);
  void look(Pattern pattern, const Samples& samples, std::size_t count);
  void look_at_sky(Pattern pattern, const SurfaceBatch& surface, const Samples& samples);
  [[nodiscard]] const Lanes<float>& of_surfaces(std::size_t count);
  void send(const SurfaceBatch& surface, const Lanes<std::uint8_t>& wanted);

  // What is aligned for vectors comes first, so that little is left empty between.
  RayBatch rays_;
  HitBatch hits_;
  SurfaceBatch seen_;
  VectorLanes sunlight_;
  VectorLanes skylight_;
  VectorLanes towards_;
  RayBatch light_rays_;
  SurfaceBatch bounce_;
  TileSums sums_;
  std::array<Eigen::Array4f, tile_pixels> backdrop_;  // of each pixel

  const Setting& s_;
  int left_ = 0;
  int top_ = 0;
  int width_ = 0;
  int height_ = 0;
  std::size_t sample_count_ = 0;
  std::bitset<tile_pixels> wanting_;
  std::array<bool, tile_pixels> asking_{};  // whose samples ask what is hidden of the sky
  TileNoise noise_;

  Samples samples_;
  Samples seen_samples_;
  Samples bounce_samples_;
  MarkedLanes on_ribbon_;
  MarkedLanes on_obstacle_;
  MarkedLanes on_nothing_;
  MarkedLanes asked_for_;  // the lane whose light each of light_rays_ asks for
  LaneList bounce_of_;     // the lane that receives light from there
  Lanes<float> place_x_;   // where samples look, in pixels
  Lanes<float> place_y_;
  Lanes<float> disc_x_;
  Lanes<float> disc_y_;
  Lanes<float> free_;
  Lanes<float> free_of_surfaces_;
};

}  // namespace ribbon
