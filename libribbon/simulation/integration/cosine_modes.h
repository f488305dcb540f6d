// Cosines across the ribbon: how columns that are mirrored at both selvages can swing, each by
// itself.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/integration/fours.h"

namespace ribbon {

// Of so many columns as many modes, orthonormal, four by four. Where the last four has none left,
// it has zeros.
class CosineModes {
 public:
  explicit CosineModes(int columns);

  [[nodiscard]] int four_count() const { return static_cast<int>(at_modes_.size()); }

  // The sum of the squares of what springs between columns so far apart are stretched by a mode. 0
  // where no columns are.
  [[nodiscard]] double cost(int mode, int columns_apart) const;

  // Overwrites `amplitudes`, of each row of the ribbon, with those of one four. particles: the
  // ribbon's x 3.
  void take_apart(const Eigen::MatrixX3d& particles, int four,
                  std::vector<FourVectors>& amplitudes) const;

  // The inverse, of rows from `begin` to `end` and all fours.
  void put_together(const std::vector<std::vector<FourVectors>>& amplitudes, int begin, int end,
                    Eigen::MatrixX3d& particles) const;

 private:
  int columns_;
  std::vector<std::vector<Fours<1>>> at_columns_;  // the modes of each four, at each column
  std::vector<std::vector<Fours<1>>> at_modes_;    // each mode, at four columns
};

}  // namespace ribbon
