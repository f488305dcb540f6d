// What could not be read.
#pragma once

#include <cstdint>
#include <string>

namespace ribbon {

// A part of the file that could not be read.
struct Damage {
  std::uint64_t byte = 0;    // where it begins
  std::uint64_t length = 0;  // how many bytes were skipped
  std::string reason;
};

}  // namespace ribbon
