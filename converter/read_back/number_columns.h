// Numbers that a file holds in a row, as what they are for. Both throw Spoiled.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace ribbon {

// All of them, so many in a column.
Eigen::MatrixXd columns(const std::vector<double>& numbers, Eigen::Index rows);

// The same as whole numbers, all of which an int can hold.
Eigen::MatrixXi whole_columns(const std::vector<double>& numbers, Eigen::Index rows);

}  // namespace ribbon
