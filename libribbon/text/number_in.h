// Numbers as people write them.
#pragma once

#include <charconv>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace ribbon {

// What the text is as a whole, whatever the locale: "-12", "2.5e-3"; also "inf" and "nan" where
// Number has them. Nothing where it is anything else, begins with a plus or a space, or is more
// than a Number can hold.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, number);
  return problem == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

// What a text tells that short_number() wrote. By a stream: not every standard library has
// std::from_chars() for numbers with decimals.
template <class Number>
Number number_told(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  Number number = 0;
  stream >> number;
  return number;
}

}  // namespace ribbon
