// The middle of some particles.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

namespace ribbon {

// Of particles one after the other, each with its share in it; shares add up to 1. What it refers
// to must outlive it.
struct Middle {
  int first = 0;  // particle
  std::span<const double> shares;

  [[nodiscard]] bool is_of_one() const { return shares.size() == 1; }

  // Of what each particle has (particles x 3).
  [[nodiscard]] Eigen::RowVector3d of(const Eigen::MatrixX3d& numbers) const {
    Eigen::RowVector3d sum = shares[0] * numbers.row(first);
    for (std::size_t i = 1; i < shares.size(); ++i)
      sum += shares[i] * numbers.row(first + static_cast<Eigen::Index>(i));
    return sum;
  }

  // Adds to what each has as much of a vector as it has a share.
  void add(const Eigen::RowVector3d& vector, Eigen::MatrixX3d& numbers) const {
    Eigen::Index particle = first;
    for (const double share : shares) numbers.row(particle++) += share * vector;
  }
};

}  // namespace ribbon
