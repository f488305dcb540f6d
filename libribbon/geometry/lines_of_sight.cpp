#include "geometry/lines_of_sight.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ribbon {

namespace {

using Eigen::Vector2d;

// A place on the border of two triangles belongs to both, whatever rounding does: of twice the
// triangle's area.
constexpr double border = 1e-9;

double twice_area(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace

void HeightRange::include(const HeightRange& range) {
  low = std::min(low, range.low);
  high = std::max(high, range.high);
}

LinesOfSight::LinesOfSight(Eigen::Matrix3Xd seen, Eigen::Matrix3Xi triangles)
    : seen_(std::move(seen)), triangles_(std::move(triangles)) {
  const auto count = static_cast<int>(triangles_.cols());
  nodes_.reserve(static_cast<std::size_t>(2) * static_cast<std::size_t>(count));
  if (count > 0) add_node(0, count);
}

int LinesOfSight::add_node(int first, int end) {
  const auto index = static_cast<int>(nodes_.size());
  Node node{seen_.col(triangles_(0, first)).head<2>(), seen_.col(triangles_(0, first)).head<2>(),
            first, end};
  for (int triangle = first; triangle < end; ++triangle)
    for (const int corner : triangles_.col(triangle)) {
      node.low = node.low.cwiseMin(seen_.col(corner).head<2>());
      node.high = node.high.cwiseMax(seen_.col(corner).head<2>());
    }
  const Vector2d size = node.high - node.low;
  nodes_.push_back(node);
  if (end - first == 1) return index;
  const int middle = first + (end - first) / 2;
  sort_halves(first, middle, end, size.x() >= size.y() ? 0 : 1);
  add_node(first, middle);
  const int second = add_node(middle, end);
  nodes_[static_cast<std::size_t>(index)].second_child = second;
  return index;
}

// Those whose middles come first along a coordinate of the view before the others.
void LinesOfSight::sort_halves(int first, int middle, int end, int coordinate) {
  std::vector<std::pair<double, Eigen::Vector3i>> order;
  for (int triangle = first; triangle < end; ++triangle) {
    const Eigen::Vector3i corners = triangles_.col(triangle);
    double sum = 0;
    for (const int corner : corners) sum += seen_(coordinate, corner);
    order.emplace_back(sum, corners);
  }
  std::nth_element(order.begin(), order.begin() + (middle - first), order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (int triangle = first; triangle < end; ++triangle)
    triangles_.col(triangle) = order[static_cast<std::size_t>(triangle - first)].second;
}

std::optional<double> LinesOfSight::height_of(int triangle, const Vector2d& place) const {
  const std::array<Eigen::Vector3d, 3> corners = {seen_.col(triangles_(0, triangle)),
                                                  seen_.col(triangles_(1, triangle)),
                                                  seen_.col(triangles_(2, triangle))};
  const auto seen = [&](int k) -> Vector2d {
    return corners[static_cast<std::size_t>(k)].head<2>();
  };
  const double area = twice_area(seen(0), seen(1), seen(2));
  if (area == 0) return std::nullopt;
  const std::array<double, 3> shares = {twice_area(place, seen(1), seen(2)) / area,
                                        twice_area(seen(0), place, seen(2)) / area,
                                        twice_area(seen(0), seen(1), place) / area};
  // Not finite either where the triangle is all but edge-on.
  if (!std::all_of(shares.begin(), shares.end(),
                   [](double share) { return share >= -border && share <= 1 + border; }))
    return std::nullopt;
  return shares[0] * corners[0].z() + shares[1] * corners[1].z() + shares[2] * corners[2].z();
}

std::optional<HeightRange> LinesOfSight::through(const Vector2d& place) const {
  std::optional<HeightRange> range;
  std::vector<int> waiting;
  if (!nodes_.empty()) waiting.push_back(0);
  while (!waiting.empty()) {
    const int index = waiting.back();
    waiting.pop_back();
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if ((place.array() < node.low.array()).any() || (place.array() > node.high.array()).any())
      continue;
    if (node.end - node.first > 1) {
      waiting.insert(waiting.end(), {index + 1, node.second_child});
    } else if (const auto height = height_of(node.first, place)) {
      if (!range) range = HeightRange{*height, *height};
      range->include({*height, *height});
    }
  }
  return range;
}

}  // namespace ribbon
