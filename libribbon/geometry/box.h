// Axis-aligned boxes.
#pragma once

#include <Eigen/Core>

namespace ribbon {

struct Box {
  Eigen::Vector3d low;
  Eigen::Vector3d high;

  static Box around(const Eigen::Vector3d& point) { return {point, point}; }
  void include(const Eigen::Vector3d& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  void include(const Box& box) {
    low = low.cwiseMin(box.low);
    high = high.cwiseMax(box.high);
  }
  void grow(double margin) {
    low.array() -= margin;
    high.array() += margin;
  }
  [[nodiscard]] bool meets(const Box& box) const {
    return low[0] <= box.high[0] && box.low[0] <= high[0] && low[1] <= box.high[1] &&
           box.low[1] <= high[1] && low[2] <= box.high[2] && box.low[2] <= high[2];
  }
};

}  // namespace ribbon
