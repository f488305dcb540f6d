#include "simulation/integration/block_band.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <random>
#include <vector>

#include "parallel/any_instructions.h"

namespace ribbon::block_band_test {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class Numbers {
 public:
  Matrix3d matrix() {
    Matrix3d result;
    for (double& value : result.reshaped()) value = number();
    return result;
  }
  double number() { return between_(random_); }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> between_{-1, 1};
};

void write(const Matrix3d& matrix, int lane, FourBlocks& blocks) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) blocks[i][j][lane] = matrix(i, j);
}

// Four systems, other in each lane, and written out in full.
struct Systems {
  explicit Systems(int rows) : band(rows), right_hand_sides(rows) {
    Numbers numbers;
    for (int lane = 0; lane < 4; ++lane) {
      MatrixXd matrix = MatrixXd::Zero(3 * Index{rows}, 3 * Index{rows});
      for (int row = 0; row < rows; ++row) {
        const Matrix3d some = numbers.matrix();
        put(some + some.transpose() + 12 * Matrix3d::Identity(), row, 0, lane, matrix);
        put(numbers.matrix(), row, 1, lane, matrix);
        put(numbers.matrix(), row, 2, lane, matrix);
        for (int axis = 0; axis < 3; ++axis) right_hand_sides[row][axis][lane] = numbers.number();
      }
      matrices.push_back(matrix);
    }
  }

  // The block of a row that couples it with one so many rows before.
  void put(const Matrix3d& block, int row, int before, int lane, MatrixXd& matrix) {
    BlockBand::Row& blocks = band.row(row);
    write(block, lane,
          before == 0   ? blocks.diagonal
          : before == 1 ? blocks.one_before
                        : blocks.two_before);
    if (row < before) return;  // it counts for nothing
    const Index i = 3 * Index{row};
    const Index j = 3 * Index{row - before};
    matrix.block<3, 3>(i, j) = block;
    matrix.block<3, 3>(j, i) = block.transpose();
  }

  BlockBand band;
  std::vector<FourVectors> right_hand_sides;
  std::vector<MatrixXd> matrices;
};

VectorXd of_lane(const std::vector<FourVectors>& rows, int lane) {
  VectorXd result(3 * static_cast<Index>(rows.size()));
  Index i = 0;
  for (const FourVectors& row : rows)
    for (const Four& axis : row) result[i++] = axis[lane];
  return result;
}

TEST(BlockBand, solves_four_systems) {
  for (const int rows : {1, 2, 3, 40}) {
    Systems systems(rows);
    std::vector<FourVectors> x = systems.right_hand_sides;
    systems.band.factor();
    systems.band.solve(x);
    for (int lane = 0; lane < 4; ++lane) {
      const VectorXd expected =
          systems.matrices[lane].partialPivLu().solve(of_lane(systems.right_hand_sides, lane));
      EXPECT_LT((of_lane(x, lane) - expected).norm(), 1e-13) << rows << " rows, lane " << lane;
    }
  }
}

TEST(BlockBand, gives_the_same_bits_with_any_instructions) {
  same_for_any_instructions([] {
    Systems systems(40);
    systems.band.factor();
    systems.band.solve(systems.right_hand_sides);
    const auto& x = systems.right_hand_sides;
    return std::array{of_lane(x, 0), of_lane(x, 1), of_lane(x, 2), of_lane(x, 3)};
  });
}

}  // namespace ribbon::block_band_test
