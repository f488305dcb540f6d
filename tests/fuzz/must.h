// What a fuzz target demands; unlike an assert also of optimised builds.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace ribbon {

inline bool same_bits(const Eigen::Matrix3Xf& a, const Eigen::Matrix3Xf& b) {
  return a.cols() == b.cols() &&
         std::equal(a.data(), a.data() + a.size(), b.data(), [](float x, float y) {
           return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
         });
}

inline void must(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "it must hold that %s\n", what);
  std::abort();
}

}  // namespace ribbon
