#include "player/chart/thinned.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ribbon {

std::vector<Eigen::Vector2f> thinned(const std::vector<Eigen::Vector2f>& points) {
  const auto column = [&](std::size_t k) { return std::floor(2 * points[k].x()); };
  std::vector<Eigen::Vector2f> kept;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    std::array<std::size_t, 4> corners{begin, begin, begin, begin};
    for (end = begin; end < points.size() && column(end) == column(begin); ++end) {
      if (points[end].y() < points[corners[1]].y()) corners[1] = end;
      if (points[end].y() > points[corners[2]].y()) corners[2] = end;
      corners[3] = end;
    }
    std::sort(corners.begin(), corners.end());
    const auto last = std::unique(corners.begin(), corners.end());
    std::for_each(corners.begin(), last, [&](std::size_t k) { kept.push_back(points[k]); });
  }
  return kept;
}

}  // namespace ribbon
