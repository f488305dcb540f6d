#include "simulation/integration/cosine_modes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "geometry/angles.h"
#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

using Eigen::Index;
using Eigen::MatrixX3d;

// Of so many parts of a right angle: no more than once round, so that none of them is lost to
// rounding.
double cosine_of_parts(int count, int parts) {
  return cosine(std::numbers::pi / 2 * (count % (4 * parts)) / parts);
}

using Table = std::vector<Fours<1>>;

// One term after the other, in each lane: Eigen's own product of matrices divides its sums as the
// processor's caches and vector instructions suggest.
[[gnu::always_inline]] inline void take_apart_rows(const Table& at_columns,
                                                   const MatrixX3d& particles,
                                                   std::vector<FourVectors>& amplitudes) {
  const std::size_t columns = at_columns.size();
  std::array<const double*, 3> row = {particles.col(0).data(), particles.col(1).data(),
                                      particles.col(2).data()};
  for (FourVectors& amplitude : amplitudes) {
    FourVectors sum{};
    for (std::size_t column = 0; column < columns; ++column)
      for (int axis = 0; axis < 3; ++axis) sum[axis] += at_columns[column][0] * row[axis][column];
    amplitude = sum;
    for (const double*& of_axis : row) of_axis += columns;
  }
}

[[gnu::always_inline]] inline void put_row_together(
    const std::vector<Table>& at_modes, const std::vector<std::vector<FourVectors>>& amplitudes,
    int row, int columns, MatrixX3d& particles) {
  for (std::size_t four = 0; four < at_modes.size(); ++four) {
    FourVectors sum{};
    const Fours<1>* mode = at_modes[four].data();
    for (const std::vector<FourVectors>& of_four : amplitudes)
      for (int lane = 0; lane < 4; ++lane, ++mode)
        for (int axis = 0; axis < 3; ++axis) sum[axis] += of_four[row][axis][lane] * (*mode)[0];
    const Index first = Index{row} * columns + 4 * static_cast<Index>(four);
    const int count = std::min(4, columns - 4 * static_cast<int>(four));
    for (int axis = 0; axis < 3; ++axis)
      for (int lane = 0; lane < count; ++lane) particles(first + lane, axis) = sum[axis][lane];
  }
}

}  // namespace

CosineModes::CosineModes(int columns) : columns_(columns) {
  const auto four_count = static_cast<std::size_t>(columns + 3) / 4;
  at_columns_.assign(four_count, Table(columns));
  at_modes_.assign(four_count, Table(4 * four_count));
  for (int mode = 0; mode < columns; ++mode)
    for (int column = 0; column < columns; ++column) {
      const double value = std::sqrt((mode == 0 ? 1.0 : 2.0) / columns) *
                           cosine_of_parts(mode * (2 * column + 1), columns);
      at_columns_[mode / 4][column][0][mode % 4] = value;
      at_modes_[column / 4][mode][0][column % 4] = value;
    }
}

double CosineModes::cost(int mode, int columns_apart) const {
  if (columns_apart >= columns_) return 0;
  return 2 - 2 * cosine_of_parts(2 * mode * columns_apart, columns_);
}

void CosineModes::take_apart(const MatrixX3d& particles, int four,
                             std::vector<FourVectors>& amplitudes) const {
  vectorised([&]() RIBBON_INLINED { take_apart_rows(at_columns_[four], particles, amplitudes); });
}

void CosineModes::put_together(const std::vector<std::vector<FourVectors>>& amplitudes, int begin,
                               int end, MatrixX3d& particles) const {
  vectorised([&]() RIBBON_INLINED {
    for (int row = begin; row < end; ++row)
      put_row_together(at_modes_, amplitudes, row, columns_, particles);
  });
}

}  // namespace ribbon
