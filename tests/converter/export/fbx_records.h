// Strict reading of a binary FBX file's record structure, for tests only.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace ribbon {

inline std::uint64_t fbx_number(std::string_view bytes, std::size_t offset) {
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

// Walks a list of records from `position`; returns where its null record ends, or 0 when a record
// does not end where it says or the null record is missing.
inline std::size_t fbx_list_end(std::string_view bytes, std::size_t position) {
  while (position + 25 <= bytes.size()) {
    if (bytes.substr(position, 25) == std::string(25, '\0')) return position + 25;
    const std::uint64_t end = fbx_number(bytes, position);
    const std::size_t children = position + 25 + static_cast<unsigned char>(bytes[position + 24]) +
                                 fbx_number(bytes, position + 16);
    const bool plain = children == end && fbx_number(bytes, position + 8) > 0;
    if (!plain && fbx_list_end(bytes.substr(0, end), children) != end) return 0;
    position = end;
  }
  return 0;
}

// Where the top-level list of a version-7500 file ends; 0: the file is not right.
inline std::size_t fbx_top_list_end(std::string_view bytes) {
  return fbx_list_end(bytes, 27);
}

}  // namespace ribbon
