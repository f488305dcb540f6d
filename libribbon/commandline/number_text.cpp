#include "commandline/number_text.h"

#include <array>
#include <cstdio>

namespace ribbon {

namespace {

// Long enough for every double with the few decimals that are asked for.
using Buffer = std::array<char, 400>;

}  // namespace

std::string decimals(double number, int digits) {
  Buffer text;
  std::snprintf(text.data(), text.size(), "%.*f", digits, number);
  return text.data();
}

std::string short_number(double number) {
  Buffer text;
  std::snprintf(text.data(), text.size(), "%g", number);
  return text.data();
}

std::string number_list(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t begin = 0; begin < numbers.size();) {
    std::size_t end = begin + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    if (begin != 0) text += ", ";
    text += std::to_string(numbers[begin]);
    if (end - begin > 1) text.append("-").append(std::to_string(numbers[end - 1]));
    begin = end;
  }
  return text;
}

}  // namespace ribbon
