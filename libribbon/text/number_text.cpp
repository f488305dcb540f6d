#include "text/number_text.h"

#include <fmt/args.h>
#include <fmt/core.h>

#include <cmath>

#include "text/number_in.h"

namespace ribbon {

std::string decimals(double number, int digits) {
  return fmt::format("{:.{}f}", number, digits);
}

std::string short_number(double number, int digits, Rounding rounding) {
  std::string text = fmt::format("{:.{}g}", number, digits);
  if (rounding == Rounding::to_nearest || !std::isfinite(number)) return text;
  const double told = number_told<double>(text);
  const double roundoff = 0x1p-50 * std::abs(number);  // 100 * 0.07 is 7
  const bool holds =
      rounding == Rounding::up ? told >= number - roundoff : told <= number + roundoff;
  if (holds) return text;
  const double last_digit = std::pow(10.0, std::floor(std::log10(std::abs(number))) - digits + 1);
  return fmt::format("{:.{}g}", number + (rounding == Rounding::up ? last_digit : -last_digit),
                     digits);
}

std::string shortest(double number) {
  return fmt::format("{}", number);
}

std::string metres(double length_m, Rounding rounding) {
  return short_number(length_m, 3, rounding) + " m";
}

std::string length_text(double length_m, int digits, Rounding rounding) {
  const std::string text = short_number(1000 * length_m, digits, rounding);
  // What is rounded to 1000 mm is a metre.
  if (length_m < 1 && number_told<double>(text) < 1000) return text + " mm";
  return short_number(length_m, digits, rounding) + " m";
}

std::string hexadecimal(std::uint32_t number) {
  return fmt::format("{:08x}", number);
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
