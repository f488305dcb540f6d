#include "simulation/start/length_text.h"

#include <array>
#include <cstdio>

namespace ribbon {

std::string to_three_digits(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", number);
  return text.data();
}

std::string metres(double length_m) {
  return to_three_digits(length_m) + " m";
}

}  // namespace ribbon
