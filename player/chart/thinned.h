// Lines with no more points than can be seen.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace ribbon {

// Of the points that lie in one column of half a pixel, one after the other, only the first, the
// highest, the lowest and the last are left: the line looks the same.
std::vector<Eigen::Vector2f> thinned(const std::vector<Eigen::Vector2f>& points);

}  // namespace ribbon
