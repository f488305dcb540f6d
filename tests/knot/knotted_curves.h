// Knots, ribbons and motions from formulas.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "geometry/ribbon_grid.h"
#include "knot/type/simplify_curve.h"

namespace ribbon {

using Curve = Eigen::Matrix3Xd;

inline Curve sampled(int count, const std::function<Eigen::Vector3d(double)>& at) {
  Curve result(3, count);
  for (int k = 0; k < count; ++k) result.col(k) = at(static_cast<double>(k) / (count - 1));
  return result;
}

// Once round a closed curve, starting just after `start` of the way and ending just before it.
inline Curve opened(const std::function<Eigen::Vector3d(double)>& closed, double start, int count) {
  return sampled(count, [&](double way) { return closed(start + 0.01 + 0.98 * way); });
}

// The torus knot that goes p times round the axis z while it winds q times round the tube; q < 0
// for the mirror image. For odd q its ends are outermost.
inline Curve torus_knot(int p, int q, int count) {
  const auto closed = [p, q](double way) {
    const double turn = 2 * std::numbers::pi * way;
    const double radius = 2 + std::cos(q * turn);
    // Right-handed for q > 0.
    return Eigen::Vector3d(radius * std::cos(p * turn), radius * std::sin(p * turn),
                           -std::sin(q * turn));
  };
  return opened(closed, 0, count);
}

inline Curve figure_eight_knot(int count) {
  const auto closed = [](double way) {
    const double turn = 2 * std::numbers::pi * way;
    return Eigen::Vector3d((2 + std::cos(2 * turn)) * std::cos(3 * turn),
                           (2 + std::cos(2 * turn)) * std::sin(3 * turn), std::sin(4 * turn));
  };
  return opened(closed, 0, count);
}

// One curve after the other, joined by a straight edge, the second one moved along x behind the
// first. Both run from their left to their right end.
inline Curve joined(const Curve& first, const Curve& second) {
  const double shift = first.row(0).maxCoeff() - second.row(0).minCoeff() + 1;
  Curve result(3, first.cols() + second.cols());
  result << first, second.colwise() + Eigen::Vector3d(shift, 0, 0);
  return result;
}

// Closed by rays that leave the first and the last point outwards, as seen from the centre.
inline LongCurve long_curve(const Curve& curve, const Eigen::Vector3d& first_ray,
                            const Eigen::Vector3d& last_ray) {
  LongCurve result{ProjectivePoint::direction(first_ray)};
  for (const auto& point : curve.colwise()) result.push_back(ProjectivePoint::point(point));
  result.push_back(ProjectivePoint::direction(last_ray));
  return result;
}

inline LongCurve long_curve(const Curve& curve) {
  const Eigen::Vector3d centre = curve.rowwise().mean();
  return long_curve(curve, curve.col(0) - centre, curve.col(curve.cols() - 1) - centre);
}

constexpr double shastri_range = 2.3;

// An overhand knot tied into a line along x from -reach to reach: right-handed, or left-handed when
// `hand` is -1. Reach is at least 3.
inline Curve overhand_knot(int count, double reach = 6, double hand = 1) {
  // The trefoil as a long polynomial knot (Shastri, "Polynomial representations of knots", 1992),
  // with nearly straight ends where |t| > 2.1.
  return sampled(count, [&](double way) {
    const double t = shastri_range * (2 * way - 1);
    const double s = std::clamp(t, -2.1, 2.1);
    const double s2 = s * s;
    const double out = t - s;
    return Eigen::Vector3d(s * s2 - 3 * s + out * (reach - 2.961) / 0.2, s2 * s2 - 4 * s2,
                           hand * (0.2 * (s2 * s2 * s - 10 * s) + out * out));
  });
}

// The right-handed one with the lower strand of one of its three crossings (at t = -0.52, below
// t = 1.93) raised by `lift`. It is 0.5 below the upper one.
inline Curve overhand_knot_lifted(int count, double lift) {
  Curve result = overhand_knot(count);
  for (int k = 0; k < count; ++k) {
    const double t = shastri_range * (2.0 * k / (count - 1) - 1);
    if (std::abs(t + 0.52) < 0.2) result(2, k) += lift;
  }
  return result;
}

// A ribbon `width` wide along a trefoil drawn as a polynomial; `depth` -1 is its mirror image.
inline Eigen::Matrix3Xd open_trefoil(const RibbonGrid& grid, double depth, double width) {
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double t = 2.2 * (2.0 * grid.row(p) / (grid.along - 1) - 1);
    positions.col(p) << t * (t * t - 3), t * t * (t * t - 4),
        depth * t * (t * t * t * t - 10) / 5 + width * grid.column(p) / (grid.across - 1);
  }
  return positions;
}

// From the middle of a sphere to a hole round its upper pole, wound round it from there down to the
// lower pole. Where the hole is small there is no way out for its first end.
inline Curve ball_with_hole(double hole_rad, double windings = 60) {
  return sampled(700, [&](double way) {
    if (way == 0) return Eigen::Vector3d(0, 0, 0);
    const double down = hole_rad + (std::numbers::pi - hole_rad) * way;
    const double round = 2 * std::numbers::pi * windings * way;
    return Eigen::Vector3d(std::sin(down) * std::cos(round), std::sin(down) * std::sin(round),
                           std::cos(down));
  });
}

inline Eigen::Matrix3d random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

// A ribbon `width` wide along `curve`. It lies as flat as it can on the plane across `up`, but for
// `turns` full right-handed turns, spread evenly.
inline Eigen::Matrix3Xf ribbon_along(const Curve& curve, int across, double width, double turns = 0,
                                     const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ()) {
  const RibbonGrid grid{static_cast<int>(curve.cols()), across};
  Eigen::Matrix3Xf result(3, grid.particle_count());
  for (int i = 0; i < grid.along; ++i) {
    const int next = std::min(i + 1, grid.along - 1);
    const int previous = std::max(i - 1, 0);
    const Eigen::Vector3d along = (curve.col(next) - curve.col(previous)).normalized();
    const double angle = 2 * std::numbers::pi * turns * i / (grid.along - 1);
    const Eigen::Vector3d sideways = Eigen::AngleAxisd(angle, along) * along.cross(up).normalized();
    for (int j = 0; j < across; ++j) {
      const double offset = width * (static_cast<double>(j) / (across - 1) - 0.5);
      result.col(grid.particle(i, j)) = (curve.col(i) + offset * sideways).cast<float>();
    }
  }
  return result;
}

}  // namespace ribbon
