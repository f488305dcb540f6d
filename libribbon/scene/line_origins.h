// Where the lines of a scene's text come from, once settings have changed it.
#pragma once

#include <string_view>
#include <vector>

namespace ribbon {

// A line of the file, from 1, or, as 0, -1, -2 ..., the first, second, third setting, which wrote
// it.
using LineOrigin = int;

// Of all lines of a text that is the file's.
std::vector<LineOrigin> origins_in_file(std::string_view text);

// Makes `origins` of the lines of `before` those of the lines of `after`, which differ in what a
// setting wrote, the nth from 0.
void trace_setting(int n, std::string_view before, std::string_view after,
                   std::vector<LineOrigin>& origins);

}  // namespace ribbon
