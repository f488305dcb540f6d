// Whole numbers in as few bytes as they need.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ribbon {

// Numbers of any size, seven bits to a byte, low bits first, the high bit set on all but the last.
void put_varint(std::string& bytes, std::uint32_t number);
std::optional<std::uint32_t> take_varint(std::string_view& bytes);

// 0 -1 1 -2 2 ... as 0 1 2 3 4 ...
inline std::uint32_t zigzag(std::int32_t number) {
  return (static_cast<std::uint32_t>(number) << 1) ^ static_cast<std::uint32_t>(number >> 31);
}
inline std::int32_t unzigzag(std::uint32_t number) {
  return static_cast<std::int32_t>((number >> 1) ^ (0 - (number & 1)));
}

}  // namespace ribbon
