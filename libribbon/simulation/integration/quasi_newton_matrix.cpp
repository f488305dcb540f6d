#include "simulation/integration/quasi_newton_matrix.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angles.h"
#include "parallel/parallel.h"

namespace ribbon {

namespace {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;
using Eigen::MatrixX3d;
using Eigen::MatrixXd;

// Of the springs: the factor could not tell less from rounding.
constexpr double least_inertia = 1e-12;

// Of so many parts of a right angle: no more than once round, so that none of them is lost to
// rounding.
double cosine_of_parts(int count, int parts) {
  return cosine(std::numbers::pi / 2 * (count % (4 * parts)) / parts);
}

// What a path mirrored at both ends has for its modes.
MatrixXd cosines(int count) {
  MatrixXd modes(count, count);
  for (int mode = 0; mode < count; ++mode)
    for (int column = 0; column < count; ++column)
      modes(mode, column) = std::sqrt((mode == 0 ? 1.0 : 2.0) / count) *
                            cosine_of_parts(mode * (2 * column + 1), count);
  return modes;
}

// How much each of these modes is changed by springs between columns so far apart.
ArrayXd cost_of_modes(int count, int apart) {
  ArrayXd cost(count);
  for (int mode = 0; mode < count; ++mode)
    cost[mode] = count > apart ? 2 - 2 * cosine_of_parts(2 * mode * apart, count) : 0.0;
  return cost;
}

// A in these modes, which do not mix: one column for each row of the ribbon, one row for each mode.
struct Diagonals {
  ArrayXXd main;
  std::array<ArrayXd, 2> beside;  // one and two rows off the main one, the same for all rows
};

// A spring counts at both of its ends. Within a row, a family costs what the mode does; between two
// rows of amplitudes a and b it costs a^2 + b^2 - 2 (1 - cost / 2) a b, half of what it costs
// together with its mirror image.
Diagonals diagonals_of(const SpringNetwork& network, double inertia, const ArrayXd& heaviness) {
  const auto [along, across] = network.grid;
  Diagonals result{ArrayXXd::Constant(across, along, inertia),
                   {ArrayXd::Zero(across), ArrayXd::Zero(across)}};
  if (heaviness.size() > 0) result.main.rowwise() *= heaviness.transpose();
  for (const SpringKind* kind : network.kinds()) {
    ArrayXXd main = ArrayXXd::Zero(across, along);
    std::array<ArrayXd, 2> beside{ArrayXd::Zero(across), ArrayXd::Zero(across)};
    for (const SpringFamily& family : kind->families) {
      const ArrayXd cost = cost_of_modes(across, std::abs(family.columns));
      if (family.rows == 0) {
        main.colwise() += cost;
      } else {
        main.leftCols(along - family.rows) += 1;
        main.rightCols(along - family.rows) += 1;
        beside[family.rows - 1] += 1 - cost / 2;
      }
    }
    result.main += kind->stiffness * main;
    for (int i = 0; i < 2; ++i) result.beside[i] -= kind->stiffness * beside[i];
  }
  return result;
}

}  // namespace

QuasiNewtonMatrix::QuasiNewtonMatrix(const SpringNetwork& network, double inertia,
                                     const ArrayXd& heaviness)
    : grid_(network.grid),
      modes_(cosines(grid_.across)),
      columns_(modes_.transpose()),
      one_before_(ArrayXXd::Zero(grid_.across, grid_.along)),
      two_before_(one_before_),
      inverse_(one_before_) {
  double stiffness = 0;
  for (const SpringKind* kind : network.kinds()) stiffness += kind->stiffness;
  factor(network, std::max(inertia, 8 * least_inertia * stiffness), heaviness);
}

void QuasiNewtonMatrix::factor(const SpringNetwork& network, double inertia,
                               const ArrayXd& heaviness) {
  auto [diagonals, beside] = diagonals_of(network, inertia, heaviness);
  for (int row = 0; row < grid_.along; ++row) {
    auto diagonal = diagonals.col(row);
    auto one = one_before_.col(row);
    auto two = two_before_.col(row);
    if (row >= 2) {
      two = beside[1] * inverse_.col(row - 2);
      diagonal -= two.square() / inverse_.col(row - 2);
    }
    if (row >= 1) {
      one = beside[0];
      if (row >= 2) one -= beside[1] * one_before_.col(row - 1);
      one *= inverse_.col(row - 1);
      diagonal -= one.square() / inverse_.col(row - 1);
    }
    inverse_.col(row) = 1 / diagonal;
  }
}

namespace {

// Column by column, one term after the other: Eigen's own product of matrices divides its sums as
// the processor's caches and vector instructions suggest.
template <class Result>
void multiply(const MatrixXd& matrix, const Eigen::Ref<const MatrixXd>& columns, Result& result) {
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    auto sum = result.col(i);
    sum = columns(0, i) * matrix.col(0);
    for (Eigen::Index k = 1; k < matrix.cols(); ++k) sum += columns(k, i) * matrix.col(k);
  }
}

}  // namespace

void QuasiNewtonMatrix::solve(const MatrixX3d& force, MatrixX3d& displacement) {
  displacement.resize(force.rows(), 3);
  parallel_ranges(3, 1, [&](Eigen::Index axis, Eigen::Index) {
    const Eigen::Map<const MatrixXd> forces(force.col(axis).data(), grid_.across, grid_.along);
    Eigen::Map<MatrixXd> displacements(displacement.col(axis).data(), grid_.across, grid_.along);
    MatrixXd& amplitudes = amplitudes_[axis];
    amplitudes.resize(grid_.across, grid_.along);
    multiply(modes_, forces, amplitudes);
    solve_along(amplitudes);
    multiply(columns_, amplitudes, displacements);
  });
}

void QuasiNewtonMatrix::solve_along(MatrixXd& amplitudes) const {
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
