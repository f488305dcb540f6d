// How many boxes have been tested against each other.
#pragma once

#include <cstddef>

namespace ribbon {

// Since the program began, by any thread; 0 where boxes do not count.
std::size_t box_tests_made();

}  // namespace ribbon
