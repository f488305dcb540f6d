#include "simulation/integration/spring_metric.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "parallel/parallel.h"

namespace ribbon {

namespace {

using Eigen::ArrayXd;
using Eigen::MatrixX3d;
using Eigen::MatrixXd;

// Of the springs: the factor could not tell less from rounding.
constexpr double least_inertia = 1e-12;

// What a path mirrored at both ends has for its modes.
MatrixXd cosines(int count) {
  MatrixXd modes(count, count);
  for (int mode = 0; mode < count; ++mode)
    for (int place = 0; place < count; ++place)
      modes(mode, place) = std::sqrt((mode == 0 ? 1.0 : 2.0) / count) *
                           std::cos(std::numbers::pi * mode * (place + 0.5) / count);
  return modes;
}

// How much each of these modes is changed by springs between places so far apart.
ArrayXd cost_of_modes(int count, int apart) {
  ArrayXd cost(count);
  for (int mode = 0; mode < count; ++mode)
    cost[mode] = count > apart ? 2 - 2 * std::cos(std::numbers::pi * mode * apart / count) : 0.0;
  return cost;
}

// How many rows there are so far before and behind a row, 0 to 2.
int neighbours(int row, int apart, int rows) {
  return (row - apart >= 0 ? 1 : 0) + (row + apart < rows ? 1 : 0);
}

}  // namespace

SpringMetric::SpringMetric(const SpringNetwork& network, const RibbonGrid& grid, double inertia)
    : grid_(grid),
      modes_(cosines(grid.across)),
      one_before_(ArrayXd::Zero(grid.across).replicate(1, grid.along)),
      two_before_(one_before_),
      inverse_(one_before_) {
  const double springs =
      network.stretch.resistance + network.shear.resistance + network.bend.resistance;
  factor(network, std::max(inertia, 8 * least_inertia * springs));
}

void SpringMetric::factor(const SpringNetwork& network, double inertia) {
  const double stretch = network.stretch.resistance;
  const double shear = network.shear.resistance;
  const double bend = network.bend.resistance;
  const ArrayXd next = cost_of_modes(grid_.across, 1);
  const ArrayXd after_next = cost_of_modes(grid_.across, 2);
  // Two rows share both diagonals of each quad, whose cost in a mode is
  // 2 (a^2 + b^2) - 2 (2 - next) a b for its amplitudes a and b in the two.
  const ArrayXd to_next_row = -stretch - shear * (2 - next);
  for (int row = 0; row < grid_.along; ++row) {
    const int beside = neighbours(row, 1, grid_.along);
    ArrayXd diagonal = inertia + stretch * (beside + next) + 2.0 * shear * beside +
                       bend * (neighbours(row, 2, grid_.along) + after_next);
    auto one = one_before_.col(row);
    auto two = two_before_.col(row);
    if (row >= 2) {
      two = -bend * inverse_.col(row - 2);
      diagonal -= two.square() / inverse_.col(row - 2);
    }
    if (row >= 1) {
      one = to_next_row;
      if (row >= 2) one += bend * one_before_.col(row - 1);
      one *= inverse_.col(row - 1);
      diagonal -= one.square() / inverse_.col(row - 1);
    }
    inverse_.col(row) = 1 / diagonal;
  }
}

void SpringMetric::solve(const MatrixX3d& force, MatrixX3d& displacement) {
  displacement.resize(force.rows(), 3);
  parallel_ranges(3, 1, [&](std::size_t axis, std::size_t) {
    const auto column = static_cast<Eigen::Index>(axis);
    const Eigen::Map<const MatrixXd> forces(force.col(column).data(), grid_.across, grid_.along);
    Eigen::Map<MatrixXd> displacements(displacement.col(column).data(), grid_.across, grid_.along);
    MatrixXd& amplitudes = amplitudes_[axis];
    amplitudes.noalias() = modes_ * forces;
    solve_along(amplitudes);
    displacements.noalias() = modes_.transpose() * amplitudes;
  });
}

void SpringMetric::solve_along(MatrixXd& amplitudes) const {
  for (int row = 1; row < grid_.along; ++row) {
    auto here = amplitudes.col(row).array();
    here -= one_before_.col(row) * amplitudes.col(row - 1).array();
    if (row >= 2) here -= two_before_.col(row) * amplitudes.col(row - 2).array();
  }
  amplitudes.array() *= inverse_;
  for (int row = grid_.along - 2; row >= 0; --row) {
    auto here = amplitudes.col(row).array();
    here -= one_before_.col(row + 1) * amplitudes.col(row + 1).array();
    if (row + 2 < grid_.along) here -= two_before_.col(row + 2) * amplitudes.col(row + 2).array();
  }
}

}  // namespace ribbon
