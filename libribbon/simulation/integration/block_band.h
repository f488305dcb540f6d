// Systems of linear equations along the ribbon, four of them side by side.
#pragma once

#include <cstddef>
#include <vector>

#include "simulation/integration/fours.h"

namespace ribbon {

// Four symmetric, positive definite matrices of 3 x 3 blocks, each of which couples a row of the
// ribbon with itself and with the two before it. The results are the same bits for any processor
// and compiler.
class BlockBand {
 public:
  // Before the first rows there is nothing: what is written there counts for nothing.
  struct Row {
    FourBlocks diagonal{};
    FourBlocks one_before{};
    FourBlocks two_before{};
  };

  explicit BlockBand(int rows) : rows_(static_cast<std::size_t>(rows)) {}

  [[nodiscard]] Row& row(int row) { return rows_[static_cast<std::size_t>(row)]; }

  // Replaces A = L D L^T by its factors: each diagonal block by the inverse of that of D, those
  // before it by those of L, of whose diagonal every block is 1.
  void factor();

  // Replaces A x by x, one vector for each row. After factor().
  void solve(std::vector<FourVectors>& x) const;

 private:
  std::vector<Row> rows_;
};

}  // namespace ribbon
