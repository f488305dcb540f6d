#include "player/render/render.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "parallel/parallel.h"
#include "player/render/coverage.h"

namespace ribbon {

namespace {

constexpr int tile_side = 16;  // pixels
constexpr int block_side = 4;  // pixels whose rays travel together
constexpr std::size_t batch_size = 256;

// Samples fall off like a tent over the neighbouring pixels, which smooths edges better than a
// pixel's square.
float tent(float uniform) {
  return uniform < 0.5F ? std::sqrt(2 * uniform) - 1 : 1 - std::sqrt(2 - 2 * uniform);
}

std::vector<Eigen::Vector2f> pixel_offsets(const SamplePatterns& patterns) {
  std::vector<Eigen::Vector2f> offsets;
  for (int s = 0; s < patterns.samples(); ++s) {
    const Eigen::Vector2f point = patterns.point(Pattern::pixel, s, 0, 0);
    offsets.emplace_back(tent(point.x()), tent(point.y()));
  }
  return offsets;
}

// Evenly over the unit disc.
Eigen::Vector2f on_disc(const Eigen::Vector2f& uniform) {
  const float radius = std::sqrt(uniform.x());
  const float angle = 2 * std::numbers::pi_v<float> * uniform.y();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Two directions that complete `axis` to a right-handed frame.
Eigen::Matrix3f frame_about(const Eigen::Vector3f& axis) {
  const Eigen::Vector3f helper =
      std::abs(axis.x()) < 0.7F ? Eigen::Vector3f::UnitX() : Eigen::Vector3f::UnitY();
  Eigen::Matrix3f frame;
  frame.col(2) = axis;
  frame.col(0) = helper.cross(axis).normalized();
  frame.col(1) = axis.cross(frame.col(0));
  return frame;
}

struct Sample {
  int x;
  int y;
  int number;
};

struct Seen {
  Sample sample;
  SurfacePoint point;
};

struct Setting {
  const RenderScene& scene;
  const Camera& camera;
  const SamplePatterns& patterns;
  const Lighting& lighting;
  const Backdrop& backdrop;
  std::vector<Eigen::Vector2f> offsets;
  Eigen::Matrix3f sun_frame;
};

// Paints one tile: collects rays into batches, so that each kind of ray is traced in full packets.
class TilePainter {
 public:
  TilePainter(const Setting& setting, LightPicture& picture) : s_(setting), picture_(picture) {}

  // A tile that is not `covered` shows the backdrop and needs no rays.
  void paint(int left, int top, bool covered) {
    const int right = std::min(left + tile_side, picture_.size.width);
    const int bottom = std::min(top + tile_side, picture_.size.height);
    if (!covered) return fill_with_backdrop(left, top, right, bottom);
    for (int y = top; y < bottom; y += block_side)
      for (int x = left; x < right; x += block_side)
        add_block(x, y, std::min(x + block_side, right), std::min(y + block_side, bottom));
    finish_batch();
    average(left, top, right, bottom);
  }

 private:
  void add_block(int left, int top, int right, int bottom) {
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        for (int number = 0; number < s_.patterns.samples(); ++number) add({x, y, number});
  }

  void add(const Sample& sample) {
    samples_[count_] = sample;
    rays_[count_] = camera_ray(sample);
    if (++count_ == batch_size) finish_batch();
  }

  [[nodiscard]] Ray camera_ray(const Sample& sample) const {
    const Eigen::Vector2f& offset = s_.offsets[sample.number];
    const float x = (static_cast<float>(sample.x) + 0.5F + offset.x()) / width_ * 2 - 1;
    const float y = 1 - (static_cast<float>(sample.y) + 0.5F + offset.y()) / height_ * 2;
    return {s_.camera.eye, s_.camera.direction(x, y)};
  }

  void finish_batch() {
    std::array<Hit, batch_size> hits;
    s_.scene.rays().first_hits({rays_.data(), count_}, Coherence::similar, hits);
    seen_count_ = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (hits[i].body == Hit::Body::none)
        pixel(samples_[i]) += background(samples_[i].y);
      else
        seen_[seen_count_++] = {samples_[i], s_.scene.point(rays_[i], hits[i])};
    }
    add_sun();
    add_sky();
    count_ = 0;
  }

  void add_sun() {
    std::array<std::size_t, batch_size> lit;
    std::array<float, batch_size> cosines;
    std::size_t rays = 0;
    for (std::size_t i = 0; i < seen_count_; ++i) {
      const SurfacePoint& point = seen_[i].point;
      const Eigen::Vector2f disc =
          s_.lighting.sun_radius * on_disc(uniform(Pattern::sun, seen_[i].sample));
      const Eigen::Vector3f towards =
          (s_.sun_frame * Eigen::Vector3f(disc.x(), disc.y(), 1)).normalized();
      const float cosine = point.normal.dot(towards);
      if (cosine <= 0) continue;
      rays_[rays] = {point.light_start, towards};
      cosines[rays] = cosine;
      lit[rays++] = i;
    }
    std::array<std::uint8_t, batch_size> free;
    s_.scene.rays().unblocked({rays_.data(), rays}, Coherence::similar, free);
    for (std::size_t r = 0; r < rays; ++r)
      if (free[r] != 0)
        pixel(seen_[lit[r]].sample) += seen_[lit[r]].point.albedo * s_.lighting.sun * cosines[r];
  }

  void add_sky() {
    for (std::size_t i = 0; i < seen_count_; ++i) {
      const SurfacePoint& point = seen_[i].point;
      const Eigen::Vector2f disc = on_disc(uniform(Pattern::sky, seen_[i].sample));
      const float height = std::sqrt(std::max(0.0F, 1 - disc.squaredNorm()));
      rays_[i] = {point.light_start,
                  frame_about(point.normal) * Eigen::Vector3f(disc.x(), disc.y(), height)};
    }
    std::array<std::uint8_t, batch_size> free;
    s_.scene.rays().unblocked({rays_.data(), seen_count_}, Coherence::mixed, free);
    for (std::size_t i = 0; i < seen_count_; ++i)
      add_sky_light(seen_[i], rays_[i].direction, free[i] != 0);
  }

  // What the whole sky would give, less what is hidden in this one direction: so a point that sees
  // all of the sky has no noise.
  void add_sky_light(const Seen& seen, const Eigen::Vector3f& towards, bool free) {
    Color light = s_.lighting.mean_sky(seen.point.normal);
    if (!free) light -= s_.lighting.sky(towards) * (1 - s_.lighting.bounce);
    pixel(seen.sample) += seen.point.albedo * light;
  }

  [[nodiscard]] Eigen::Vector2f uniform(Pattern pattern, const Sample& sample) const {
    const auto pixel = static_cast<std::uint32_t>(sample.y * picture_.size.width + sample.x);
    const std::uint32_t key = scramble(2 * pixel + (pattern == Pattern::sun ? 0U : 1U));
    return s_.patterns.point(pattern, sample.number, key, scramble(key));
  }

  [[nodiscard]] Color background(int y) const {
    const float down = (static_cast<float>(y) + 0.5F) / height_;
    return s_.backdrop.top + (s_.backdrop.bottom - s_.backdrop.top) * down;
  }

  Color& pixel(const Sample& sample) {
    return picture_.pixels[static_cast<std::size_t>(sample.y) * picture_.size.width + sample.x];
  }

  void fill_with_backdrop(int left, int top, int right, int bottom) {
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) pixel({x, y, 0}) = background(y);
  }

  void average(int left, int top, int right, int bottom) {
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        pixel({x, y, 0}) /= static_cast<float>(s_.patterns.samples());
  }

  const Setting& s_;
  LightPicture& picture_;
  float width_ = static_cast<float>(picture_.size.width);
  float height_ = static_cast<float>(picture_.size.height);
  std::array<Sample, batch_size> samples_;
  std::array<Ray, batch_size> rays_;
  std::array<Seen, batch_size> seen_;
  std::size_t count_ = 0;
  std::size_t seen_count_ = 0;
};

}  // namespace

LightPicture render(const RenderScene& scene, const Camera& camera, PictureSize size,
                    const SamplePatterns& patterns, const Lighting& lighting,
                    const Backdrop& backdrop) {
  const Setting setting{scene,
                        camera,
                        patterns,
                        lighting,
                        backdrop,
                        pixel_offsets(patterns),
                        frame_about(lighting.sun_direction)};
  LightPicture picture{size, std::vector<Color>(size.pixel_count(), Color::Zero())};
  TileCoverage tiles(camera, size, tile_side);
  tiles.mark(scene.ribbon());
  tiles.mark(scene.obstacle());
  const auto count = static_cast<std::size_t>(tiles.columns()) * tiles.rows();
  parallel_ranges(count, 1, [&](std::size_t begin, std::size_t end) {
    const FlushDenormals fast;
    TilePainter painter(setting, picture);
    for (std::size_t tile = begin; tile < end; ++tile) {
      const int column = static_cast<int>(tile) % tiles.columns();
      const int row = static_cast<int>(tile) / tiles.columns();
      painter.paint(column * tile_side, row * tile_side, tiles.covered(column, row));
    }
  });
  return picture;
}

}  // namespace ribbon
