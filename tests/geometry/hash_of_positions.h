// One number for all bits of a ribbon's positions.
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>

namespace ribbon {

// FNV-1a, of 64 bits at a time.
inline std::uint64_t hash_of(const Eigen::Matrix3Xd& positions) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const double value : positions.reshaped())
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3;
  return hash;
}

}  // namespace ribbon
