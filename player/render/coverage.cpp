#include "player/render/coverage.h"

#include <algorithm>
#include <utility>

namespace ribbon {

namespace {

// A pixel's samples reach one pixel beyond its centre; the rest is for rounding.
constexpr float sample_reach = 1.6F;

}  // namespace

TileCoverage::TileCoverage(Camera camera, PictureSize size, int tile_side)
    : camera_(std::move(camera)),
      size_(size),
      tile_side_(tile_side),
      columns_((size.width + tile_side - 1) / tile_side),
      rows_((size.height + tile_side - 1) / tile_side),
      covered_(static_cast<std::size_t>(columns_) * rows_, 0) {}

void TileCoverage::mark(const Surface& surface) {
  const Eigen::Index count = surface.vertices.cols();
  Eigen::Matrix2Xf pixels(2, count);
  for (Eigen::Index v = 0; v < count; ++v) {
    const Eigen::Vector3f seen = camera_.project(surface.vertices.col(v));
    if (seen.z() <= 0) {  // beside or behind the eye, where projection says nothing
      mark_all();
      return;
    }
    pixels.col(v) << (seen.x() + 1) / 2 * static_cast<float>(size_.width),
        (1 - seen.y()) / 2 * static_cast<float>(size_.height);
  }
  for (const auto triangle : surface.triangles.colwise()) {
    const Eigen::Vector2f a = pixels.col(triangle[0]);
    const Eigen::Vector2f b = pixels.col(triangle[1]);
    const Eigen::Vector2f c = pixels.col(triangle[2]);
    mark_box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
  }
}

void TileCoverage::mark_all() {
  std::fill(covered_.begin(), covered_.end(), std::uint8_t{1});
}

void TileCoverage::mark_box(const Eigen::Vector2f& low, const Eigen::Vector2f& high) {
  const auto tile = [this](float pixel, int tiles) {
    const float clamped = std::clamp(pixel, -1.0F, 65536.0F);
    return std::clamp(static_cast<int>(clamped) / tile_side_, 0, tiles - 1);
  };
  const int right = tile(high.x() + sample_reach, columns_);
  const int bottom = tile(high.y() + sample_reach, rows_);
  for (int row = tile(low.y() - sample_reach, rows_); row <= bottom; ++row)
    for (int column = tile(low.x() - sample_reach, columns_); column <= right; ++column)
      covered_[static_cast<std::size_t>(row) * columns_ + column] = 1;
}

}  // namespace ribbon
