// Damage to bytes.
#pragma once

#include <cstddef>
#include <string>

namespace ribbon {

// With some bits of one byte turned.
inline std::string flipped(std::string bytes, std::size_t at, int bits = 0xFF) {
  bytes.at(at) = static_cast<char>(bytes.at(at) ^ bits);
  return bytes;
}

}  // namespace ribbon
