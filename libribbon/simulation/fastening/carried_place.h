// Where a hand that carries a part of the band wants to have it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/state/state_archive.h"

namespace ribbon {

// A place that goes from where the part was straight to the begin of a way and then along it, at
// one speed, and stays at its end.
class CarriedPlace {
 public:
  // way: 3 x points, at least one, m.
  CarriedPlace(const Eigen::Vector3d& from, const Eigen::Matrix3Xd& way);

  [[nodiscard]] Eigen::Vector3d now() const { return after(0); }
  // Where it is when it has gone on by so much.
  [[nodiscard]] Eigen::Vector3d after(double distance_m) const;
  void go_on(double distance_m);
  [[nodiscard]] bool has_arrived() const { return gone_m_ >= ends_m_.back(); }

  void visit_state(StateArchive& archive);

 private:
  Eigen::Matrix3Xd corners_;
  std::vector<double> ends_m_;  // distance from the first corner to each
  double gone_m_ = 0;
};

}  // namespace ribbon
