#include "simulation/integration/quasi_newton_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/vectors.h"
#include "parallel/parallel.h"

namespace ribbon {

namespace {

using Eigen::ArrayXd;
using Eigen::Matrix3d;
using Eigen::MatrixX3d;
using Eigen::RowVector3d;

// Of the springs: the factor could not tell less from rounding.
constexpr double least_inertia = 1e-12;

// Of its stiffness, what a spring resists across it. Less, and steps become so long that the line
// search must shorten them; more, and they stay short.
constexpr double resistance_across = 0.05;

constexpr int rows_in_task = 64;

// Squares of lengths below which a spring has no direction.
constexpr double shortest_squared = 1e-300;

// P of a spring. Without a direction it resists in all.
Matrix3d resistance_of(const RowVector3d& spring) {
  const double squared_length = squared_length_of(spring);
  if (squared_length < shortest_squared) return Matrix3d::Identity();
  return resistance_across * Matrix3d::Identity() +
         (1 - resistance_across) / squared_length * spring.transpose() * spring;
}

// block += weight matrix
void add(const Four& weight, const Matrix3d& matrix, FourBlocks& block) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) block[i][j] += weight * matrix(i, j);
}

}  // namespace

QuasiNewtonMatrix::QuasiNewtonMatrix(const SpringNetwork& network, double inertia,
                                     const ArrayXd& heaviness)
    : grid_(network.grid),
      modes_(grid_.across),
      bands_(modes_.four_count(), BlockBand(grid_.along)),
      amplitudes_(modes_.four_count(), std::vector<FourVectors>(grid_.along)) {
  double stiffness = 0;
  for (const SpringKind* kind : network.kinds()) {
    stiffness += kind->stiffness;
    for (const SpringFamily& springs : kind->families) {
      if (kind->stiffness == 0) continue;
      Family& family = families_.emplace_back();
      family.springs = {springs.rows, springs.columns};
      family.stiffness = kind->stiffness;
      family.cost.resize(modes_.four_count());
      for (int mode = 0; mode < grid_.across; ++mode)
        family.cost[mode / 4][0][mode % 4] = modes_.cost(mode, std::abs(springs.columns));
      family.resistance.resize(grid_.along);
    }
  }
  inertia_ = ArrayXd::Constant(grid_.along, std::max(inertia, 8 * least_inertia * stiffness));
  if (heaviness.size() > 0) inertia_ *= heaviness;
}

void QuasiNewtonMatrix::factor(const MatrixX3d& positions) {
  parallel_ranges(grid_.along, rows_in_task, [&](std::size_t begin, std::size_t end) {
    for (Family& family : families_)
      for (std::size_t row = begin; row < end; ++row)
        look_along(static_cast<int>(row), positions, family);
  });
  parallel_ranges(bands_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t four = begin; four < end; ++four) {
      assemble(static_cast<int>(four));
      bands_[four].factor();
    }
  });
}

void QuasiNewtonMatrix::look_along(int row, const MatrixX3d& positions, Family& family) const {
  Matrix3d& mean = family.resistance[row];
  mean.setZero();
  if (row + family.springs.rows >= grid_.along) return;
  int count = 0;
  for_each_spring_of_row(grid_, family.springs, row, [&](int a, int b) {
    mean += resistance_of(positions.row(b) - positions.row(a));
    ++count;
  });
  if (count > 0) mean *= family.stiffness / count;
}

// A spring counts at both of its ends. Within a row, a family costs what the mode does; between two
// rows of amplitudes a and b it costs a^2 + b^2 - 2 (1 - cost / 2) a b, half of what it costs
// together with its mirror image.
void QuasiNewtonMatrix::assemble(int four) {
  for (int row = 0; row < grid_.along; ++row) {
    BlockBand::Row& blocks = bands_[four].row(row);
    blocks = {};
    add(Four{} + inertia_[row], Matrix3d::Identity(), blocks.diagonal);
    for (const auto& [springs, stiffness, costs, resistance] : families_) {
      const Four& cost = costs[four][0];
      if (springs.rows == 0) {
        add(cost, resistance[row], blocks.diagonal);
        continue;
      }
      add(Four{} + 1, resistance[row], blocks.diagonal);
      if (row < springs.rows) continue;
      const Matrix3d& before = resistance[row - springs.rows];
      add(Four{} + 1, before, blocks.diagonal);
      add(cost / 2 - 1, before, springs.rows == 1 ? blocks.one_before : blocks.two_before);
    }
  }
}

void QuasiNewtonMatrix::solve(const MatrixX3d& force, MatrixX3d& displacement) {
  displacement.resize(force.rows(), 3);
  parallel_ranges(bands_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t four = begin; four < end; ++four) {
      modes_.take_apart(force, static_cast<int>(four), amplitudes_[four]);
      bands_[four].solve(amplitudes_[four]);
    }
  });
  parallel_ranges(grid_.along, rows_in_task, [&](std::size_t begin, std::size_t end) {
    modes_.put_together(amplitudes_, static_cast<int>(begin), static_cast<int>(end), displacement);
  });
}

}  // namespace ribbon
