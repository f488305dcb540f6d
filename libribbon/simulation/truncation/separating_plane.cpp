#include "simulation/truncation/separating_plane.h"

#include <algorithm>

#include "geometry/vectors.h"
#include "simulation/truncation/approach.h"

namespace ribbon {

namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;
using Corners = Eigen::Matrix<double, 3, 4>;

// The part of the room that one truncation may use up; the rest keeps rounding harmless.
constexpr double usable = 0.9;

// By a plane perpendicular to `normal`, over which the first feature lies above the second; none
// may go where that leaves no more than least_gap_m between them.
Vector4d fractions_beside_plane(int of_first, const Vector3d& normal, const Corners& start,
                                const Corners& displacement, double least_gap_m,
                                double min_separation_m) {
  const Vector4d height = heights(start, normal);
  const Vector4d rise = heights(displacement, normal);
  const double lowest_first = height.head(of_first).minCoeff();
  const double highest_second = height.tail(4 - of_first).maxCoeff();
  if (lowest_first - highest_second <= least_gap_m) return Vector4d::Zero();
  const double room_m = std::max(0.0, usable * (lowest_first - highest_second - min_separation_m));
  const double sink_first = std::max(0.0, -rise.head(of_first).minCoeff());
  const double climb_second = std::max(0.0, rise.tail(4 - of_first).maxCoeff());
  Vector4d fractions = Vector4d::Ones();
  if (sink_first + climb_second <= room_m) return fractions;

  const double room_per_metre = room_m / (sink_first + climb_second);
  const double floor_of_first = lowest_first - sink_first * room_per_metre;
  const double ceiling_of_second = highest_second + climb_second * room_per_metre;
  for (int k = 0; k < of_first; ++k)
    if (rise[k] < 0 && height[k] + rise[k] < floor_of_first)
      fractions[k] = room_m > 0 ? (height[k] - floor_of_first) / -rise[k] : 0;
  for (int k = of_first; k < 4; ++k)
    if (rise[k] > 0 && height[k] + rise[k] > ceiling_of_second)
      fractions[k] = room_m > 0 ? (ceiling_of_second - height[k]) / rise[k] : 0;
  return fractions.cwiseMin(1).cwiseMax(0);
}

}  // namespace

Vector4d displacement_fractions(FeaturePair::Kind kind, const Corners& start,
                                const Vector4d& weights, const Corners& displacement,
                                double min_separation_m) {
  const int of_first = first_count(kind);
  const Vector3d apart = weighted_sum(start, weights);
  const double distance_m = length_of(apart);
  if (distance_m == 0) return Vector4d::Zero();  // no direction separates what already touches
  // Its gap is the distance, but almost touching features lie aslant to the rounded direction: it
  // does not separate them.
  Vector4d at_start = fractions_beside_plane(of_first, apart / distance_m, start, displacement, 0,
                                             min_separation_m);
  if (at_start.minCoeff() == 1) return at_start;

  const Vector3d met = approach_down_to(min_separation_m, kind, start, weights, displacement).apart;
  const Vector4d on_the_way = fractions_beside_plane(
      of_first, met / length_of(met), start, displacement, min_separation_m, min_separation_m);
  return on_the_way.minCoeff() > at_start.minCoeff() ? on_the_way : at_start;
}

}  // namespace ribbon
