// Numbers as people read them.
#pragma once

#include <string>
#include <vector>

namespace ribbon {

// With a fixed number of decimals: "4.10".
std::string decimals(double number, int digits);

// As short as six significant digits allow: "0.25", "1e-05".
std::string short_number(double number);

// "3, 7-9, 12" of numbers in ascending order.
std::string number_list(const std::vector<int>& numbers);

}  // namespace ribbon
