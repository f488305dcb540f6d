#include "simulation/integration/quasi_newton_matrix.h"

#include <algorithm>
#include <cstddef>

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

// n n^T of springs, summed.
class Directions {
 public:
  // Without a direction a spring counts in all.
  void add(double x, double y, double z) {
    const double squared_length = x * x + y * y + z * z;
    ++count_;
    if (squared_length < shortest_squared) {
      sum_.diagonal().array() += 1;
      return;
    }
    const double scale = 1 / squared_length;
    sum_(0, 0) += scale * x * x;
    sum_(0, 1) += scale * x * y;
    sum_(0, 2) += scale * x * z;
    sum_(1, 1) += scale * y * y;
    sum_(1, 2) += scale * y * z;
    sum_(2, 2) += scale * z * z;
  }
  // The mean P; 0 of none.
  [[nodiscard]] Matrix3d mean_resistance() const {
    if (count_ == 0) return Matrix3d::Zero();
    Matrix3d mean = (1 - resistance_across) / count_ * sum_;
    mean.triangularView<Eigen::StrictlyLower>() = mean.transpose();
    mean.diagonal().array() += resistance_across;
    return mean;
  }

 private:
  Matrix3d sum_ = Matrix3d::Zero();  // its upper half
  int count_ = 0;
};

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
      heaviness_(heaviness.size() > 0 ? heaviness : ArrayXd::Ones(grid_.along)),
      bands_(modes_.four_count(), BlockBand(grid_.along)),
      amplitudes_(modes_.four_count(), std::vector<FourVectors>(grid_.along)) {
  double stiffness = 0;
  for (const SpringKind* kind : network.kinds()) {
    stiffness += kind->stiffness;
    for (const auto& [rows, columns, rest_m, rests_m] : kind->families) {
      if (kind->stiffness == 0 || columns < 0) continue;
      Springs& springs = springs_.emplace_back();
      springs.families.push_back({rows, columns});
      if (rows > 0 && columns > 0) springs.families.push_back({rows, -columns});
      springs.stiffness = kind->stiffness;
      springs.cost.resize(modes_.four_count());
      for (int mode = 0; mode < grid_.across; ++mode)
        springs.cost[mode / 4][0][mode % 4] = modes_.cost(mode, columns);
      springs.resistance.resize(grid_.along);
    }
  }
  least_inertia_ = 8 * least_inertia * stiffness;
  set_inertia(inertia);
}

void QuasiNewtonMatrix::set_inertia(double inertia) {
  inertia_ = std::max(inertia, least_inertia_) * heaviness_;
}

void QuasiNewtonMatrix::factor(const MatrixX3d& positions, std::span<const SharedSpring> held) {
  held_.setZero(grid_.along);
  for (const SharedSpring& spring : held)
    if (spring.middle.is_of_one())
      held_[grid_.row(spring.middle.first)] += spring.stiffness / grid_.across;
  parallel_ranges(grid_.along, rows_in_task, [&](std::size_t begin, std::size_t end) {
    for (Springs& springs : springs_)
      for (std::size_t row = begin; row < end; ++row)
        look_along(static_cast<int>(row), positions, springs);
  });
  parallel_ranges(bands_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t four = begin; four < end; ++four) {
      assemble(static_cast<int>(four));
      bands_[four].factor();
    }
  });
  coupled_ = 0;
  for (const SharedSpring& spring : held)
    if (!spring.middle.is_of_one()) couple(spring);
}

void QuasiNewtonMatrix::couple(const SharedSpring& spring) {
  for (int axis = 0; axis < 3; ++axis) {
    if (couplings_.size() == coupled_) couplings_.emplace_back();
    Coupling& coupling = couplings_[coupled_];
    coupling.middle = spring.middle;
    coupling.axis = axis;
    by_shares_.setZero(grid_.particle_count(), 3);
    spring.middle.add(RowVector3d::Unit(axis), by_shares_);
    solve(by_shares_, coupling.answer);
    coupling.yielding = 1 / spring.stiffness + spring.middle.of(coupling.answer)[axis];
    ++coupled_;
  }
}

void QuasiNewtonMatrix::look_along(int row, const MatrixX3d& positions, Springs& springs) const {
  Directions directions;
  for (const SpringFamily& family : springs.families) {
    if (row + family.rows >= grid_.along) continue;
    for_each_spring_of_row(grid_, family, row, [&](int a, int b) {
      directions.add(positions(b, 0) - positions(a, 0), positions(b, 1) - positions(a, 1),
                     positions(b, 2) - positions(a, 2));
    });
  }
  springs.resistance[row] = springs.stiffness * static_cast<double>(springs.families.size()) *
                            directions.mean_resistance();
}

// A spring counts at both of its ends. Within a row, springs cost what the mode does; between two
// rows of amplitudes a and b they cost a^2 + b^2 - 2 (1 - cost / 2) a b, a family half of what it
// costs together with its mirror image.
void QuasiNewtonMatrix::assemble(int four) {
  const Four once = Four{} + 1;
  for (int row = 0; row < grid_.along; ++row) {
    BlockBand::Row& blocks = bands_[four].row(row);
    blocks = {};
    Matrix3d of_all_modes = (inertia_[row] + held_[row]) * Matrix3d::Identity();
    for (const Springs& springs : springs_) {
      const Four& cost = springs.cost[four][0];
      const int rows = springs.families[0].rows;
      if (rows == 0) {
        add(cost, springs.resistance[row], blocks.diagonal);
        continue;
      }
      of_all_modes += springs.resistance[row];
      if (row < rows) continue;
      const Matrix3d& before = springs.resistance[row - rows];
      of_all_modes += before;
      add(cost / 2 - once, before, rows == 1 ? blocks.one_before : blocks.two_before);
    }
    add(once, of_all_modes, blocks.diagonal);
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
  for (std::size_t i = 0; i < coupled_; ++i) {
    const Coupling& coupling = couplings_[i];
    const double force_n = coupling.middle.of(displacement)[coupling.axis] / coupling.yielding;
    displacement -= force_n * coupling.answer;
  }
}

}  // namespace ribbon
