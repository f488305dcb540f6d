#include "player/render/render.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "parallel/parallel.h"
#include "player/render/coverage.h"
#include "player/render/pixel_planes.h"
#include "player/render/sky_filter.h"
#include "player/render/thread_timer.h"
#include "player/render/tile_painter.h"

namespace ribbon {

namespace {

constexpr std::size_t tiles_at_once =
    4;  // enough work to be worth a painter, little enough to share

// What one tile adds to the report.
struct TileCount {
  double samples = 0;
  double error = 0;  // root of the mean square over its pixels
  double paint_s = 0;
  int pixels = 0;
};

class PicturePainter {
 public:
  PicturePainter(const RenderScene& scene, const Camera& camera, PictureSize size,
                 const RenderSettings& settings, const SamplePatterns& patterns)
      : size_(size),
        rays_(camera, size, patterns),
        backdrop_(settings.backdrop, camera, size),
        timed_(settings.timed),
        setting_{scene, rays_, patterns, settings.quality, settings.lighting, backdrop_, size},
        tiles_(camera, size, tile_side),
        counts_(static_cast<std::size_t>(tiles_.columns()) * tiles_.rows()) {
    tiles_.mark(scene.ribbon());
    tiles_.mark(scene.obstacle());
    if (scene.has_ground()) tiles_.mark_all();
  }

  // Calls take(x, y, shown, surface) with the sums of every pixel of a covered tile and
  // leave(x, y, backdrop) for the others.
  template <class Take, class Leave>
  void paint(const Take& take, const Leave& leave) {
    parallel_ranges(counts_.size(), tiles_at_once, [&](std::size_t begin, std::size_t end) {
      const FlushDenormals fast;
      TilePainter painter(setting_);
      for (std::size_t tile = begin; tile < end; ++tile) {
        const int column = static_cast<int>(tile) % tiles_.columns();
        const int row = static_cast<int>(tile) / tiles_.columns();
        const bool covered = tiles_.covered(column, row);
        if (!covered) {
          leave_tile(column * tile_side, row * tile_side, leave);
          continue;
        }
        counts_[tile].paint_s = paint_tile(painter, column * tile_side, row * tile_side);
        counts_[tile].error = painter.error();
        for_pixels(column * tile_side, row * tile_side, [&](int x, int y) {
          const int tile_x = x - column * tile_side;
          const int tile_y = y - row * tile_side;
          const Eigen::Array4f& shown = painter.shown(tile_x, tile_y);
          take(x, y, shown, painter.surface(tile_x, tile_y));
          counts_[tile].samples += shown[3];
          ++counts_[tile].pixels;
        });
      }
    });
  }

  [[nodiscard]] RenderReport report() const {
    RenderReport report;
    double pixels = 0;
    for (const TileCount& tile : counts_) {
      pixels += tile.pixels;
      report.samples += tile.samples;
      report.paint_s += tile.paint_s;
      report.error += tile.error * tile.error * tile.pixels;
      if (is_above_noise(tile.error)) report.wanting += tile.pixels;
    }
    pixels = std::max(pixels, 1.0);
    report.samples /= pixels;
    report.wanting /= pixels;
    report.error = std::sqrt(report.error / pixels);
    return report;
  }

 private:
  // How long it took, if that is asked for.
  [[nodiscard]] double paint_tile(TilePainter& painter, int left, int top) const {
    std::optional<ThreadTimer> timer;
    if (timed_) timer.emplace();
    painter.paint(left, top);
    return timer ? timer->seconds() : 0;
  }

  [[nodiscard]] bool is_above_noise(double error) const {
    return setting_.quality.noise > 0 && error > setting_.quality.noise;
  }

  template <class Function>
  void for_pixels(int left, int top, const Function& function) const {
    const int right = std::min(left + tile_side, size_.width);
    const int bottom = std::min(top + tile_side, size_.height);
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) function(x, y);
  }

  template <class Leave>
  void leave_tile(int left, int top, const Leave& leave) const {
    for_pixels(left, top, [&](int x, int y) { leave(x, y, backdrop_.at(x, y)); });
  }

  PictureSize size_;
  CameraRays rays_;
  BackdropView backdrop_;
  bool timed_;
  Setting setting_;
  TileCoverage tiles_;
  std::vector<TileCount> counts_;
};

std::size_t index_of(int x, int y, PictureSize size) {
  return static_cast<std::size_t>(y) * size.width + x;
}

// The first three numbers.
void set_planes(Planes& planes, std::size_t pixel, const auto& value) {
  for (int channel = 0; channel < 3; ++channel) planes[channel][pixel] = value[channel];
}

// first_samples: those that tell of normals and positions.
void fill_pixel(const Eigen::Array4f& shown, const SurfaceSums& sums, int first_samples,
                std::size_t pixel, PixelPlanes& planes) {
  const float samples = shown[3];
  set_planes(planes.direct, pixel, sums.direct(shown) / samples);
  set_planes(planes.albedo, pixel, sums.albedo / samples);
  // Samples that saw the backdrop know nothing of it.
  set_planes(planes.sky, pixel, sums.sky / std::max(sums.normal[3], 1.0F));
  set_planes(planes.position, pixel, sums.position / static_cast<float>(first_samples));
  const float length = sums.normal.matrix().head<3>().norm();
  set_planes(planes.normal, pixel, sums.normal / std::max(length, 1e-20F));
  planes.evenness[pixel] = sums.saw_one_surface(samples) ? sums.normal[3] : 0;
}

void leave_pixel(const Color& backdrop, std::size_t pixel, PixelPlanes& planes) {
  set_planes(planes.direct, pixel, backdrop);
  set_planes(planes.albedo, pixel, Color(0, 0, 0));
  planes.evenness[pixel] = 0;
}

LightPicture composed(const PixelPlanes& planes) {
  LightPicture light{planes.size, std::vector<Color>(planes.size.pixel_count())};
  parallel_ranges(light.pixels.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t channel = 0; channel < 3; ++channel)
        light.pixels[i][static_cast<Eigen::Index>(channel)] =
            planes.direct[channel][i] + planes.albedo[channel][i] * planes.sky[channel][i];
  });
  return light;
}

// What a pixel covers at the ribbon.
float pixel_m(const RenderScene& scene, const Camera& camera, PictureSize size) {
  const Eigen::Vector3f middle = scene.ribbon().vertices.rowwise().mean();
  return (middle - camera.eye).norm() * 2 * camera.half_height / static_cast<float>(size.height);
}

}  // namespace

Renderer::Renderer(RenderSettings settings)
    : settings_(std::move(settings)),
      patterns_(std::max(settings_.quality.samples, settings_.quality.most_samples)) {}

Rendered Renderer::render(const RenderScene& scene, const Camera& camera, PictureSize size) {
  PicturePainter painter(scene, camera, size, settings_, patterns_);
  if (!settings_.quality.smooth_sky) {
    LightPicture light{size, std::vector<Color>(size.pixel_count())};
    painter.paint(
        [&](int x, int y, const Eigen::Array4f& shown, const SurfaceSums&) {
          light.pixels[index_of(x, y, size)] = shown.head<3>() / shown[3];
        },
        [&](int x, int y, const Color& backdrop) {
          light.pixels[index_of(x, y, size)] = backdrop;
        });
    return {std::move(light), painter.report()};
  }
  if (!planes_ || planes_->size != size) planes_.emplace(size);
  PixelPlanes& planes = *planes_;
  painter.paint(
      [&](int x, int y, const Eigen::Array4f& shown, const SurfaceSums& surface) {
        fill_pixel(shown, surface, settings_.quality.first_samples(), index_of(x, y, size), planes);
      },
      [&](int x, int y, const Color& backdrop) {
        leave_pixel(backdrop, index_of(x, y, size), planes);
      });
  smooth_sky(planes, pixel_m(scene, camera, size));
  return {composed(planes), painter.report()};
}

}  // namespace ribbon
