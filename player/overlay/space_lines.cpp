#include "player/overlay/space_lines.h"

#include <algorithm>
#include <cmath>

#include "parallel/parallel.h"
#include "player/picture/strokes.h"

namespace ribbon {

namespace {

// A line is seen or hidden in pieces of at most so many pixels.
constexpr float piece_pixels = 2;
// A line counts as hidden only by what is nearer to the eye by more than this part of its distance:
// far more than rounding, far less than layers are apart.
constexpr float nearer = 1e-4F;

struct Part {
  float begin = 0;  // 0 to 1 along the line
  float end = 1;
};

// What is left of the part where a value that changes evenly from `first` to `last` is not
// negative.
void keep_positive(float first, float last, Part& part) {
  if (first < 0 && last < 0) part.end = part.begin;
  if ((first < 0) == (last < 0)) return;
  const float change = first / (first - last);
  if (first < 0)
    part.begin = std::max(part.begin, change);
  else
    part.end = std::min(part.end, change);
}

class LinePainter {
 public:
  LinePainter(const RenderScene& scene, const Camera& camera, PictureSize size)
      : scene_(scene), camera_(camera), size_(size) {}

  // Cuts what is before the eye and inside the picture into pieces.
  void add(const Eigen::Vector3f& first, const Eigen::Vector3f& last) {
    const Part part = inside(first, last);
    if (!(part.begin < part.end)) return;
    const auto at = [&](float t) { return Eigen::Vector3f(first + t * (last - first)); };
    const float pixels = (pixel(at(part.end)) - pixel(at(part.begin))).norm();
    const int count = std::max(1, static_cast<int>(std::ceil(pixels / piece_pixels)));
    const float step = (part.end - part.begin) / static_cast<float>(count);
    for (int k = 0; k < count; ++k) {
      const float begin = part.begin + static_cast<float>(k) * step;
      pieces_.push_back({at(begin), at(begin + step)});
    }
  }

  void draw(const LineStyle& style, Picture& picture) const {
    std::vector<std::uint8_t> seen(pieces_.size());
    parallel_ranges(pieces_.size(), batch_size,
                    [&](std::size_t begin, std::size_t end) { look(begin, end, seen); });
    Strokes strokes(size_);
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      const float opacity = seen[k] != 0 ? style.opacity : style.hidden_opacity;
      if (opacity > 0)
        strokes.add(pixel(pieces_[k].begin), pixel(pieces_[k].end), style.width, opacity);
    }
    strokes.draw(style.ink, picture);
  }

 private:
  struct Piece {
    Eigen::Vector3f begin;
    Eigen::Vector3f end;
  };

  [[nodiscard]] Part inside(const Eigen::Vector3f& first, const Eigen::Vector3f& last) const {
    const Eigen::Matrix3f camera_from_world = camera_.world_from_camera.transpose();
    const Eigen::Vector3f a = camera_from_world * (first - camera_.eye);
    const Eigen::Vector3f b = camera_from_world * (last - camera_.eye);
    Part part;
    for (const auto& [axis, half] : {std::pair(0, camera_.half_width), {1, camera_.half_height}})
      for (const float side : {-1.0F, 1.0F})
        keep_positive(side * a[axis] - a.z() * half, side * b[axis] - b.z() * half, part);
    return part;
  }

  [[nodiscard]] Eigen::Vector2f pixel(const Eigen::Vector3f& point) const {
    const Eigen::Vector3f seen = camera_.project(point);
    return {(seen.x() + 1) / 2 * static_cast<float>(size_.width),
            (1 - seen.y()) / 2 * static_cast<float>(size_.height)};
  }

  // Asks for each piece of a range, at most batch_size of them, whether its middle is seen.
  void look(std::size_t begin, std::size_t end, std::vector<std::uint8_t>& seen) const {
    const FlushDenormals fast;
    RayBatch rays;
    for (std::size_t k = begin; k < end; ++k)
      rays.add({camera_.eye, (pieces_[k].begin + pieces_[k].end) / 2 - camera_.eye});
    HitBatch hits;
    scene_.rays().first_hits(rays, Coherence::similar, hits);
    for (std::size_t lane = 0; lane < rays.count; ++lane)
      seen[begin + lane] = hits.distance[lane] >= 1 - nearer ? 1 : 0;
  }

  const RenderScene& scene_;
  const Camera& camera_;
  PictureSize size_;
  std::vector<Piece> pieces_;
};

}  // namespace

SpaceLines polyline(Eigen::Matrix3Xf points) {
  SpaceLines result{std::move(points), {}};
  for (int k = 0; k + 1 < result.points.cols(); ++k) result.lines.push_back({k, k + 1});
  return result;
}

void draw_lines(const SpaceLines& lines, const LineStyle& style, const RenderScene& scene,
                const Camera& camera, Picture& picture) {
  LinePainter painter(scene, camera, picture.size);
  for (const auto& [first, last] : lines.lines)
    painter.add(lines.points.col(first), lines.points.col(last));
  painter.draw(style, picture);
}

}  // namespace ribbon
