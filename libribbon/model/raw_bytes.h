// Numbers as they lie in memory, which is how most binary formats hold them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cstddef>
#include <string_view>

namespace ribbon {

static_assert(std::endian::native == std::endian::little, "the formats expect this order");

// Column after column; valid as long as the matrix.
template <class Derived>
std::string_view raw_bytes(const Eigen::PlainObjectBase<Derived>& matrix) {
  return {reinterpret_cast<const char*>(matrix.data()),
          static_cast<std::size_t>(matrix.size()) * sizeof(typename Derived::Scalar)};
}

// Turns the bytes of each number round, for formats of the other order. What the numbers are
// afterwards means nothing: only their bytes do.
template <class Derived>
void swap_bytes(Eigen::PlainObjectBase<Derived>& matrix) {
  constexpr std::size_t size = sizeof(typename Derived::Scalar);
  char* const bytes = reinterpret_cast<char*>(matrix.data());
  for (Eigen::Index i = 0; i < matrix.size(); ++i)
    std::reverse(bytes + i * size, bytes + (i + 1) * size);
}

}  // namespace ribbon
