#include "knot/motion/ribbon_curves.h"

#include <cmath>
#include <cstdint>

#include "geometry/single_precision.h"

namespace ribbon {
namespace {

int middle_column(const RibbonGrid& grid) {
  return (grid.across - 1) / 2;
}

Eigen::Matrix3Xd column(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions, int j) {
  Eigen::Matrix3Xd result(3, grid.along);
  for (int i = 0; i < grid.along; ++i)
    result.col(i) = positions.col(grid.particle(i, j)).cast<double>();
  return result;
}

// A share of the way from column j to the next. Between two rows the line bends where it leaves one
// triangle for the next, on the diagonal.
Eigen::Matrix3Xd between_columns(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions, int j,
                                 double share) {
  const Eigen::Matrix3Xd left = column(grid, positions, j);
  const Eigen::Matrix3Xd right = column(grid, positions, j + 1);
  Eigen::Matrix3Xd result(3, 2 * left.cols() - 1);
  for (Eigen::Index i = 0; i < left.cols(); ++i) {
    result.col(2 * i) = (1 - share) * left.col(i) + share * right.col(i);
    if (i + 1 == left.cols()) continue;
    const bool rising = (i + j) % 2 == 0;  // as RibbonGrid::triangles() draws its diagonals
    result.col(2 * i + 1) =
        (1 - share) * left.col(rising ? i : i + 1) + share * right.col(rising ? i + 1 : i);
  }
  return result;
}

// Sebastiano Vigna's SplitMix64, as a number in [-1, 1).
double scatter(std::uint64_t index) {
  std::uint64_t z = (index + 1) * 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  z ^= z >> 31U;
  return std::ldexp(static_cast<double>(z >> 11U), -52) - 1;
}

double quarter_of_last_place(const Eigen::Matrix3Xf& positions) {
  const float largest = positions.cwiseAbs().maxCoeff();
  return largest == 0 ? 0 : last_place(largest) / 4;
}

// The nearer it is to the centre line, the less comes between the two.
Eigen::Matrix3Xd beside_centre(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions) {
  constexpr double beside = 0.125;
  const double centre = grid.across % 2 == 1 ? 0 : 0.5;
  return between_columns(grid, positions, middle_column(grid), centre + beside);
}

Eigen::Matrix3Xd scattered(Eigen::Matrix3Xd curve, double distance, std::uint64_t curve_number) {
  auto index = curve_number << 40U;
  for (double& coordinate : curve.reshaped()) coordinate += distance * scatter(index++);
  return curve;
}

}  // namespace

Eigen::Matrix3Xd centre_line(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions) {
  const int middle = middle_column(grid);
  return grid.across % 2 == 1 ? column(grid, positions, middle)
                              : between_columns(grid, positions, middle, 0.5);
}

RibbonCurves ribbon_curves(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions) {
  const double distance = quarter_of_last_place(positions);
  return {scattered(centre_line(grid, positions), distance, 0),
          scattered(column(grid, positions, 0), distance, 1),
          scattered(column(grid, positions, grid.across - 1), distance, 2),
          scattered(beside_centre(grid, positions), distance, 3)};
}

}  // namespace ribbon
