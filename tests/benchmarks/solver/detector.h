// Ways to find the pairs of features that a step could bring together, to be compared.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "geometry/ribbon_grid.h"
#include "simulation/detection/feature_pairs.h"

namespace ribbon {

enum class DetectionMethod {
  brute_force,        // each triangle against each other
  space_enumeration,  // those that share a cell of a uniform grid (paper, section 5.4.3)
  curvature,          // the hierarchy as published: curvature and boxes
  boxes,              // the hierarchy where nothing may be missed: boxes alone
  patches,            // what the gate uses: flatness and boxes, nothing missed either
};

// A ribbon that moves during a step; columns are particles, row by row.
struct RibbonMotion {
  RibbonGrid grid;
  Eigen::Matrix3Xd t0;
  Eigen::Matrix3Xd t1;
  double margin_m = 0;  // pairs that stay farther apart than this do not matter
};

// One detection, from positions to pairs of features; what can be kept between the steps of a run
// was made before.
using Detector = std::function<std::vector<FeaturePair>()>;

// The motion must outlive the detector. cell_factor: size of a cell of the space enumeration, in
// mean sizes of the boxes.
Detector make_detector(DetectionMethod method, const RibbonMotion& motion, double cell_factor);

}  // namespace ribbon
