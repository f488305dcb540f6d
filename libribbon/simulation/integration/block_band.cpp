#include "simulation/integration/block_band.h"

#include <cassert>

#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

// c -= a b^T
[[gnu::always_inline]] inline void subtract_product(const FourBlocks& a, const FourBlocks& b,
                                                    FourBlocks& c) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) c[i][j] -= a[i][k] * b[j][k];
}

// a b, of a symmetric b.
[[gnu::always_inline]] inline void multiply(const FourBlocks& a, const FourBlocks& b,
                                            FourBlocks& product) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      product[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
}

// Of a symmetric block, by its cofactors.
[[gnu::always_inline]] inline void invert(FourBlocks& block) {
  const Four xx = block[0][0];
  const Four xy = block[0][1];
  const Four xz = block[0][2];
  const Four yy = block[1][1];
  const Four yz = block[1][2];
  const Four zz = block[2][2];
  const Four of_xx = yy * zz - yz * yz;
  const Four of_xy = xz * yz - xy * zz;
  const Four of_xz = xy * yz - xz * yy;
  const Four scale = 1 / (xx * of_xx + xy * of_xy + xz * of_xz);
  block[0] = {{of_xx * scale, of_xy * scale, of_xz * scale}};
  block[1] = {{block[0][1], (xx * zz - xz * xz) * scale, (xy * xz - xx * yz) * scale}};
  block[2] = {{block[0][2], block[1][2], (xx * yy - xy * xy) * scale}};
}

// x -= block y
[[gnu::always_inline]] inline void subtract_product(const FourBlocks& block, const FourVectors& y,
                                                    FourVectors& x) {
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) x[i] -= block[i][k] * y[k];
}

// x -= block^T y
[[gnu::always_inline]] inline void subtract_transposed(const FourBlocks& block,
                                                       const FourVectors& y, FourVectors& x) {
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) x[i] -= block[k][i] * y[k];
}

[[gnu::always_inline]] inline void factor_rows(std::vector<BlockBand::Row>& rows) {
  for (std::size_t r = 0; r < rows.size(); ++r) {
    auto& [diagonal, one_before, two_before] = rows[r];
    if (r >= 2) {
      const FourBlocks before = two_before;
      multiply(before, rows[r - 2].diagonal, two_before);
      subtract_product(two_before, before, diagonal);
      subtract_product(before, rows[r - 1].one_before, one_before);
    }
    if (r >= 1) {
      const FourBlocks before = one_before;
      multiply(before, rows[r - 1].diagonal, one_before);
      subtract_product(one_before, before, diagonal);
    }
    invert(diagonal);
  }
}

[[gnu::always_inline]] inline void solve_rows(const std::vector<BlockBand::Row>& rows,
                                              std::vector<FourVectors>& x) {
  const std::size_t count = rows.size();
  for (std::size_t r = 1; r < count; ++r) {
    if (r >= 2) subtract_product(rows[r].two_before, x[r - 2], x[r]);
    subtract_product(rows[r].one_before, x[r - 1], x[r]);
  }
  for (std::size_t r = count; r-- > 0;) {
    const FourBlocks& inverse = rows[r].diagonal;
    const FourVectors y = x[r];
    for (int i = 0; i < 3; ++i)
      x[r][i] = inverse[i][0] * y[0] + inverse[i][1] * y[1] + inverse[i][2] * y[2];
    if (r + 2 < count) subtract_transposed(rows[r + 2].two_before, x[r + 2], x[r]);
    if (r + 1 < count) subtract_transposed(rows[r + 1].one_before, x[r + 1], x[r]);
  }
}

}  // namespace

void BlockBand::factor() {
  vectorised([this]() RIBBON_INLINED { factor_rows(rows_); });
}

void BlockBand::solve(std::vector<FourVectors>& x) const {
  assert(x.size() == rows_.size());
  vectorised([&]() RIBBON_INLINED { solve_rows(rows_, x); });
}

}  // namespace ribbon
