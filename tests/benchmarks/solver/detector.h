// Ways to find the pairs of features that a step could bring together, to be compared.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace benchmark {

enum class Method {
  brute_force,        // each triangle against each other
  space_enumeration,  // those that share a cell of a uniform grid (paper, section 5.4.3)
  curvature,          // the hierarchy as published: curvature and boxes
  boxes,              // the hierarchy where nothing may be missed: boxes alone
  patches,            // what the gate uses: flatness and boxes, nothing missed either
};

// A ribbon that moves during a step; columns are particles, row by row.
struct Motion {
  int along = 0;
  int across = 0;
  Eigen::Matrix3Xd t0;
  Eigen::Matrix3Xd t1;
  double margin_m = 0;  // pairs that stay farther apart than this do not matter
};

// Kind (0 vertex and triangle, 1 two edges) and the four vertices, in the order of a FeaturePair.
using Feature = std::array<int, 5>;

class Detector {
 public:
  virtual ~Detector() = default;

  // One detection, from positions to pairs of features; what can be kept between the steps of a run
  // was made before.
  virtual void detect() = 0;

  // The pairs that the last detection listed, in its order.
  [[nodiscard]] virtual std::vector<Feature> listed() const = 0;

  // Tests of a box against a box (of triangles, edges, vertices or regions) in all detections so
  // far. 0 where they are not counted.
  [[nodiscard]] virtual std::size_t box_tests() const = 0;
};

}  // namespace benchmark

// Every method exists twice: as the product compiles it, and compiled under another name with boxes
// that count their tests. The motion must outlive the detector.
// cell_factor: size of a cell of the space enumeration, in mean sizes of the boxes.
namespace ribbon {
std::unique_ptr<benchmark::Detector> make_detector(benchmark::Method method,
                                                   const benchmark::Motion& motion,
                                                   double cell_factor);
}
namespace counted {
std::unique_ptr<benchmark::Detector> make_detector(benchmark::Method method,
                                                   const benchmark::Motion& motion,
                                                   double cell_factor);
}
