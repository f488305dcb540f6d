#include "simulation/vertex_ranges.h"

namespace ribbon {

std::vector<Box> vertex_ranges(const Eigen::Matrix3Xd& t0, const Eigen::Matrix3Xd& t1) {
  std::vector<Box> ranges(static_cast<std::size_t>(t0.cols()));
  for (Eigen::Index vertex = 0; vertex < t0.cols(); ++vertex) {
    Box& range = ranges[static_cast<std::size_t>(vertex)];
    range = Box::around(t0.col(vertex));
    range.include(t1.col(vertex));
  }
  return ranges;
}

}  // namespace ribbon
