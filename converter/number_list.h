// Frame numbers as people write them.
#pragma once

#include <string>
#include <vector>

namespace ribbon {

// "4-6, 9" for 4, 5, 6, 9: consecutive ascending numbers become one span.
std::string number_list(const std::vector<int>& numbers);

}  // namespace ribbon
