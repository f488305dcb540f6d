// Reports to read: names on the left, values in one column.
#pragma once

#include <string>

namespace ribbon {

// `name` has at most 15 letters; empty: the value belongs to the line above.
inline std::string report_line(const std::string& name, const std::string& value) {
  constexpr std::size_t column = 16;
  return name + std::string(column - name.size(), ' ') + value + "\n";
}

}  // namespace ribbon
