#include "text/number_text.h"

#include <fmt/args.h>
#include <fmt/core.h>

#include <cmath>

namespace ribbon {

std::string decimals(double number, int digits) {
  return fmt::format("{:.{}f}", number, digits);
}

std::string short_number(double number, int digits) {
  return fmt::format("{:.{}g}", number, digits);
}

std::string shortest(double number) {
  return fmt::format("{}", number);
}

std::string metres(double length_m) {
  return short_number(length_m, 3) + " m";
}

std::string length_text(double length_m, int digits) {
  // What is rounded to 1000 mm is a metre.
  if (length_m >= 1 - 0.5 * std::pow(10.0, -digits)) return short_number(length_m, digits) + " m";
  return short_number(1000 * length_m, digits) + " mm";
}

std::string filled_in(std::string_view pattern, std::initializer_list<TextValue> values) {
  fmt::dynamic_format_arg_store<fmt::format_context> arguments;
  for (const TextValue& value : values)
    std::visit([&arguments](const auto& known) { arguments.push_back(known); }, value);
  return fmt::vformat(pattern, arguments);
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
