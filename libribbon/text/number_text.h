// Numbers as people read them, whatever the locale.
#pragma once

#include <string>
#include <vector>

namespace ribbon {

// With a fixed number of decimals: "4.10".
std::string decimals(double number, int digits);

// As short as that many significant digits allow: "0.25", "1e-05".
std::string short_number(double number, int digits = 6);

// Three significant digits and the unit: "0.0123 m".
std::string metres(double length_m);

// "3, 7-9, 12" of numbers in ascending order.
std::string number_list(const std::vector<int>& numbers);

}  // namespace ribbon
