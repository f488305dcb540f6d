#include "player/picture/strokes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ribbon {

namespace {

// Squared distance from a point to a segment.
float squared_distance(const Eigen::Vector2f& point, const Eigen::Vector2f& begin,
                       const Eigen::Vector2f& edge) {
  const float length = edge.squaredNorm();
  const float along = length > 0 ? std::clamp((point - begin).dot(edge) / length, 0.0F, 1.0F) : 0;
  return (point - begin - along * edge).squaredNorm();
}

// The first pixel, and the one behind the last, whose centres lie between low and high.
std::pair<int, int> pixels_between(float low, float high, int count) {
  const auto limit = static_cast<float>(count);
  return {static_cast<int>(std::ceil(std::clamp(low - 0.5F, 0.0F, limit))),
          static_cast<int>(std::floor(std::clamp(high - 0.5F, -1.0F, limit - 1))) + 1};
}

}  // namespace

Strokes::Strokes(PictureSize size) : size_(size), coverage_(size.pixel_count(), 0) {}

// A pixel is covered as far as a line that passes its centre at that distance covers it, whatever
// the line's direction.
void Strokes::add(const Eigen::Vector2f& begin, const Eigen::Vector2f& end, float width,
                  float opacity) {
  // Thinner than a pixel, lines get paler instead.
  const float ink = opacity * std::min(width, 1.0F);
  const float half = std::max(width, 1.0F) / 2;
  const float reach = half + 0.5F;
  const Eigen::Vector2f low = begin.cwiseMin(end).array() - reach;
  const Eigen::Vector2f high = begin.cwiseMax(end).array() + reach;
  const auto [left, right] = pixels_between(low.x(), high.x(), size_.width);
  const auto [top, bottom] = pixels_between(low.y(), high.y(), size_.height);
  const Eigen::Vector2f edge = end - begin;
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      const Eigen::Vector2f centre(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
      const float squared = squared_distance(centre, begin, edge);
      if (squared >= reach * reach) continue;
      const float covered = ink * std::min(reach - std::sqrt(squared), 1.0F);
      auto& pixel = coverage_[static_cast<std::size_t>(y) * size_.width + x];
      pixel = std::max(pixel, static_cast<std::uint8_t>(std::lround(255 * covered)));
    }
}

void Strokes::draw(const Color& ink, Picture& picture) const {
  assert(picture.size == size_);
  const auto bytes = srgb_bytes(ink);
  for (std::size_t i = 0; i < coverage_.size(); ++i)
    if (coverage_[i] != 0) blend(bytes, coverage_[i], picture.rgb.data() + 3 * i);
}

}  // namespace ribbon
