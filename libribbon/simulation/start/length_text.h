// Numbers in sentences about a scene.
#pragma once

#include <string>

namespace ribbon {

// Three significant digits: "0.0123", "1.5e+08".
std::string to_three_digits(double number);

// The same with its unit: "0.0123 m".
std::string metres(double length_m);

}  // namespace ribbon
