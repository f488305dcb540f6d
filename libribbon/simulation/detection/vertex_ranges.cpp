#include "simulation/detection/vertex_ranges.h"

namespace ribbon {

std::vector<MovingBox> vertex_ranges(const Eigen::Matrix3Xd& t0, const Eigen::Matrix3Xd& t1) {
  std::vector<MovingBox> ranges(t0.cols());
  for (Eigen::Index vertex = 0; vertex < t0.cols(); ++vertex)
    ranges[vertex] = {Box::around(t0.col(vertex)), Box::around(t1.col(vertex))};
  return ranges;
}

}  // namespace ribbon
