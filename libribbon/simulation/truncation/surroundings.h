// What the ribbon could touch until the next detection.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "simulation/detection/bodies.h"
#include "simulation/detection/feature_pairs.h"

namespace ribbon {

// Every vertex has a range that it does not leave until the next detection, and every pair of
// features that could come within reach of each other inside those ranges is listed. One detection
// thus serves all that moves the vertices within a step: what is not listed cannot meet.
//
// Ranges move with the cloth: the vertices start together, each at its place, go the same part of
// their ways at every instant, and then stay in the boxes at the end. So neighbours that travel
// far together are not listed. The range of a straggler, which something stops on its way, reaches
// back to its place.
struct Surroundings {
  Eigen::Matrix3Xd from;            // where the vertices were at the detection
  std::vector<MovingBox> ranges;    // one for each vertex
  std::vector<FeaturePair> pairs;   // ribbon-ribbon and ribbon-obstacle, each once
  std::vector<double> distances_m;  // of the pairs, at the detection
};

struct SurveyLengths {
  double reach_m = 0;        // pairs that could come this close are listed
  double slack_m = 0;        // room of a range beyond the expected way, for what moves it later
  double longest_way_m = 0;  // no range reaches further along the way, however far the wish lies
};

// Detects around the way from `from` to `wished` (3 x vertices each). The obstacle's vertices stay.
Surroundings survey(Bodies& bodies, const SurveyLengths& lengths, const Eigen::Matrix3Xd& from,
                    const Eigen::Matrix3Xd& wished);

// Widens the ranges of some particles, wherever they are in theirs, to reach on to where they wish
// to be now, and, for stragglers, back to where they were at the detection. Pairs with these
// particles are listed anew; the others stay.
enum class Widening { onward, onward_and_back };
void widen(std::span<const int> particles, Widening widening, Bodies& bodies,
           const SurveyLengths& lengths, const Eigen::Matrix3Xd& wished,
           Surroundings& surroundings);

// Indices, in order, of the listed pairs that may come within distance_m of each other while all
// vertices move from `positions` along equal parts of their `way` (3 x vertices each). Pairs whose
// vertices move together are told apart from those that approach.
std::vector<std::size_t> approaching_pairs(const Surroundings& surroundings,
                                           const Eigen::Matrix3Xd& positions,
                                           const Eigen::Matrix3Xd& way, double distance_m);

// The vertices that wish to be outside their ranges at the end.
std::vector<int> vertices_outside(const Surroundings& surroundings, const Eigen::Matrix3Xd& wished);

}  // namespace ribbon
