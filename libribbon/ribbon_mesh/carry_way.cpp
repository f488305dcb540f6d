#include "ribbon_mesh/carry_way.h"

#include <algorithm>
#include <cstddef>
#include <variant>

#include "curve/axis_view.h"
#include "curve/joined_drawing.h"
#include "geometry/lengths_along.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Of the length, at which each point stands.
std::vector<double> shares_of(const std::vector<Vector2d>& points) {
  std::vector<double> shares = lengths_along(points);
  const double length = shares.back();
  for (double& share : shares) share = length > 0 ? share / length : 0;
  return shares;
}

// On the straight line between the two nearest shares; beyond them as at the first or last one.
template <class Value>
Value at(double share, const std::vector<double>& shares, const std::vector<Value>& values) {
  const auto above = std::upper_bound(shares.begin(), shares.end(), share);
  if (above == shares.begin()) return values.front();
  if (above == shares.end()) return values.back();
  const auto i = static_cast<std::size_t>(above - shares.begin());
  const double t = (share - shares[i - 1]) / (shares[i] - shares[i - 1]);
  return values[i - 1] + t * (values[i] - values[i - 1]);
}

}  // namespace

Result<std::vector<Vector2d>> drawn_path(const CurveScene& curve, const PathId& path) {
  const auto* svg = std::get_if<DrawnSvg>(&curve.drawing);
  if (svg == nullptr)
    return failure("", "paths are those of an SVG file, but the drawing is a list of points",
                   "write the points of the path, for example [[0, 0], [100, 50]]");
  auto points = read_path({svg->file, path.id}, {.table = "[[stage.hand]]", .key = "carry"});
  // What is not there has no place in the drawing.
  if (!points && points.error().place == svg->file.path.string())
    return failure("", "the drawing " + points.error().problem, points.error().remedy);
  return points;
}

// Corners are where the path or its heights have some.
Matrix3Xd carry_way(const CurveScene& curve, const CarryPath& carry) {
  const auto& points = std::get<std::vector<Vector2d>>(carry.path);
  const std::vector<double> point_shares = shares_of(points);
  std::vector<double> height_shares;
  std::vector<double> heights_m;
  for (const HeightAt& height : carry.heights) {
    height_shares.push_back(height.share);
    heights_m.push_back(height.height_m);
  }
  std::vector<double> corners = point_shares;
  corners.insert(corners.end(), height_shares.begin(), height_shares.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  Matrix3Xd way(3, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d plan_m = (at(corners[i], point_shares, points) - curve.origin) * curve.unit_m;
    const Vector3d seen_m(plan_m.x(), plan_m.y(), at(corners[i], height_shares, heights_m));
    way.col(static_cast<Eigen::Index>(i)) = in_world(seen_m, curve.axis);
  }
  return way;
}

}  // namespace ribbon
