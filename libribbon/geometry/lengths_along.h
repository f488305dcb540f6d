// A polyline measured by its length.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/vectors.h"

namespace ribbon {

// From the first of the points, of which there is at least one, to each: 0, ...
template <class Points>
std::vector<double> lengths_along(const Points& points) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < points.size(); ++i)
    lengths.push_back(lengths.back() + length_of((points[i] - points[i - 1]).eval()));
  return lengths;
}

}  // namespace ribbon
