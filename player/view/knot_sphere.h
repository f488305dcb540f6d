// Where in a frame the knot is.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

struct Sphere {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  float radius_m = 0;
};

// Around all rows that lie on another part of the ribbon, or soon will: their middles are less than
// 1.2 widths from each other, but more than 2.5 along the ribbon. positions: 3 x particles, metres.
// Nothing where there are none.
std::optional<Sphere> knot_sphere(const RibbonGrid& grid, float width_m, float length_m,
                                  const Eigen::Matrix3Xf& positions);

// The knot as a camera follows it through frames that come one by one: each sphere is the mean of
// those around it, weighted by a bell of about half a second to both sides. Frames without one get
// theirs from their neighbours.
class FollowedKnot {
 public:
  // The next frame, later than those before. sphere: nothing where it has none.
  void add(double time_s, const std::optional<Sphere>& sphere);
  // No more will come.
  void end() { has_ended_ = true; }

  [[nodiscard]] int frame_count() const { return static_cast<int>(times_s_.size()); }
  // Is at(frame) what it will be when all have come?
  [[nodiscard]] bool is_settled(int frame) const;
  // As far as the frames that have come tell; those to come are taken to be like the last. Nothing
  // where none has a knot.
  [[nodiscard]] std::optional<Sphere> at(int frame) const;

 private:
  std::vector<double> times_s_;
  std::vector<Eigen::Vector4d> spheres_;  // centre and radius; between two that are known they
                                          // change evenly, before and after they stay
  std::optional<std::size_t> last_known_;
  bool has_ended_ = false;
};

}  // namespace ribbon
