// Sums over all particles in an order that is written here. Eigen's own depends on how wide the
// processor's vector instructions are.
#pragma once

#include <Eigen/Core>

namespace ribbon {

// Of as many numbers at each address: every sixteenth is added to the one sixteen before, the
// sixteen sums pairwise in the end. So many are what a processor adds at once.
double sum_of_products(const double* a, const double* b, Eigen::Index count);

double sum_of_products(const double* a, const double* b, const double* c, Eigen::Index count);

double sum_of(const double* numbers, Eigen::Index count);

// Of all entries.
inline double sum_of_products(const Eigen::MatrixX3d& a, const Eigen::MatrixX3d& b) {
  return sum_of_products(a.data(), b.data(), a.size());
}
inline double sum_of_squares(const Eigen::MatrixX3d& a) {
  return sum_of_products(a, a);
}

// Of `count` rows from `first` on.
double sum_of_products(const Eigen::MatrixX3d& a, const Eigen::MatrixX3d& b, Eigen::Index first,
                       Eigen::Index count);

// Of at least one row.
Eigen::RowVector3d mean_of_rows(const Eigen::MatrixX3d& rows);

}  // namespace ribbon
