#include "simulation/integration/cosine_modes.h"

#include <gtest/gtest.h>

#include <vector>

#include "parallel/any_instructions.h"

namespace ribbon::cosine_modes_test {

using Eigen::MatrixX3d;
using Amplitudes = std::vector<std::vector<FourVectors>>;

constexpr int rows = 5;

MatrixX3d some_particles(int columns) {
  return MatrixX3d::Random(rows * Eigen::Index{columns}, 3);
}

Amplitudes amplitudes_of(const CosineModes& modes, const MatrixX3d& particles) {
  Amplitudes amplitudes(modes.four_count(), std::vector<FourVectors>(rows));
  for (int four = 0; four < modes.four_count(); ++four)
    modes.take_apart(particles, four, amplitudes[four]);
  return amplitudes;
}

MatrixX3d put_together(const CosineModes& modes, const Amplitudes& amplitudes, int columns) {
  MatrixX3d particles(rows * Eigen::Index{columns}, 3);
  modes.put_together(amplitudes, 0, 2, particles);
  modes.put_together(amplitudes, 2, rows, particles);
  return particles;
}

// Of 1 in one row along one axis, at its columns.
MatrixX3d mode(const CosineModes& modes, int number, int columns) {
  Amplitudes amplitudes(modes.four_count(), std::vector<FourVectors>(rows));
  amplitudes[number / 4][2][1][number % 4] = 1;
  return put_together(modes, amplitudes, columns);
}

TEST(CosineModes, take_particles_apart_and_put_them_together_again) {
  for (const int columns : {2, 3, 4, 9, 16}) {
    const CosineModes modes(columns);
    const MatrixX3d particles = some_particles(columns);
    const Amplitudes amplitudes = amplitudes_of(modes, particles);
    EXPECT_LT((put_together(modes, amplitudes, columns) - particles).norm(), 1e-14) << columns;
    double squares = 0;
    for (const auto& four : amplitudes)
      for (const FourVectors& row : four)
        for (const Four& axis : row)
          for (int lane = 0; lane < 4; ++lane) squares += axis[lane] * axis[lane];
    EXPECT_NEAR(squares, particles.squaredNorm(), 1e-13) << "they are orthonormal";
  }
}

TEST(CosineModes, cost_what_springs_are_stretched_by_that_are_mirrored_in_the_selvages) {
  constexpr int columns = 7;
  const CosineModes modes(columns);
  const auto mirrored = [](int column) {
    return column < 0 ? -1 - column : column >= columns ? 2 * columns - 1 - column : column;
  };
  for (int number = 0; number < columns; ++number) {
    const auto at = [&, all = mode(modes, number, columns)](int column) {
      return all(2 * columns + mirrored(column), 1);
    };
    for (const int apart : {1, 2}) {
      // Each spring with its mirror image, half of each.
      double cost = 0;
      for (int column = 0; column < columns; ++column)
        for (const int other : {column - apart, column + apart})
          cost += (at(column) - at(other)) * (at(column) - at(other)) / 2;
      EXPECT_NEAR(modes.cost(number, apart), cost, 1e-14) << number;
    }
    EXPECT_EQ(modes.cost(number, columns), 0);
  }
}

TEST(CosineModes, give_the_same_bits_with_any_instructions) {
  constexpr int columns = 9;
  const MatrixX3d particles = some_particles(columns);
  same_for_any_instructions([&] {
    const CosineModes modes(columns);
    return put_together(modes, amplitudes_of(modes, particles), columns);
  });
}

}  // namespace ribbon::cosine_modes_test
