// Where the lines of a scene's text come from, once settings have changed it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ribbon {

struct LineOrigin {
  std::uint32_t line = 0;    // of the file, from 1
  std::string setting = {};  // or the setting that wrote it
};

// Of all lines of a text that is the file's.
std::vector<LineOrigin> origins_in_file(std::string_view text);

// Makes `origins` of the lines of `before` those of the lines of `after`, which differ in what the
// setting wrote.
void trace_setting(const std::string& setting, std::string_view before, std::string_view after,
                   std::vector<LineOrigin>& origins);

}  // namespace ribbon
