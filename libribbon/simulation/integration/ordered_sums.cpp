#include "simulation/integration/ordered_sums.h"

namespace ribbon {

namespace {

using Eigen::Index;

constexpr int lane_count = 4;
using Lanes = Eigen::Array<double, lane_count, 1>;

// Of numbers from 0 to count: four(i) gives those from i on, one(i) a single one.
template <class Four, class One>
double sum_in_lanes(Index count, const Four& four, const One& one) {
  Lanes sums = Lanes::Zero();
  Index i = 0;
  for (; i + lane_count <= count; i += lane_count) sums += four(i);
  for (int lane = 0; i < count; ++i, ++lane) sums[lane] += one(i);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

double sum_of_products(const double* a, const double* b, Index count) {
  using Four = Eigen::Map<const Lanes>;
  return sum_in_lanes(
      count, [&](Index i) { return Lanes(Four(a + i) * Four(b + i)); },
      [&](Index i) { return a[i] * b[i]; });
}

double sum_of(const double* numbers, Index count) {
  using Four = Eigen::Map<const Lanes>;
  return sum_in_lanes(
      count, [&](Index i) { return Lanes(Four(numbers + i)); },
      [&](Index i) { return numbers[i]; });
}

Eigen::RowVector3d mean_of_rows(const Eigen::MatrixX3d& rows) {
  Eigen::RowVector3d mean;
  for (int axis = 0; axis < 3; ++axis)
    mean[axis] = sum_of(rows.col(axis).data(), rows.rows()) / static_cast<double>(rows.rows());
  return mean;
}

}  // namespace ribbon
