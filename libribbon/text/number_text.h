// Numbers as people read them, alone and in sentences, whatever the locale.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace ribbon {

// With a fixed number of decimals: "4.10".
std::string decimals(double number, int digits);

// Where a number that needs more digits goes: a bound that is told has to hold.
enum class Rounding { to_nearest, down, up };

// As short as that many significant digits allow: "0.25", "1e-05".
std::string short_number(double number, int digits = 6, Rounding rounding = Rounding::to_nearest);

// With as many digits as the number needs.
std::string shortest(double number);

// Three significant digits and the unit: "0.0123 m".
std::string metres(double length_m, Rounding rounding = Rounding::to_nearest);

// In millimetres, from a metre on in metres: "12.5 mm", "86.7 m".
std::string length_text(double length_m, int digits, Rounding rounding = Rounding::to_nearest);

// Eight hexadecimal digits, as checksums and the ids of recordings are told: "008a2f33".
std::string hexadecimal(std::uint32_t number);

// A pattern of {fmt} for values of these types, in their order: "{}", "{:<17}" and the like for a
// whole number or text, "{:.1f}" or "{:.3g}" for a number with decimals. One that does not fit them
// does not compile.
template <class... Values>
class TextPattern {
 public:
  consteval TextPattern(const char* text) : text_(text) {
    const std::array<bool, sizeof...(Values)> has_decimals{std::floating_point<Values>...};
    std::size_t count = 0;
    for (std::size_t i = 0; i < text_.size(); ++i) {
      if (text_[i] != '}') continue;
      const bool of_decimals = text_[i - 1] == 'f' || text_[i - 1] == 'g';
      if (count >= has_decimals.size() || has_decimals[count] != of_decimals)
        throw "the pattern does not fit the values";
      ++count;
    }
    if (count != has_decimals.size()) throw "the pattern has no place for some values";
  }
  [[nodiscard]] constexpr std::string_view text() const { return text_; }

 private:
  std::string_view text_;
};

using TextValue = std::variant<long long, double, std::string_view>;
std::string filled_in(std::string_view pattern, std::initializer_list<TextValue> values);

inline TextValue text_value(std::integral auto number) {
  return static_cast<long long>(number);
}
inline TextValue text_value(std::floating_point auto number) {
  return static_cast<double>(number);
}
inline TextValue text_value(std::string_view text) {
  return text;
}

// "frame 3 of 7, 0.5 s" from "frame {} of {}, {:.1f} s".
template <class... Values>
std::string filled_in(TextPattern<std::type_identity_t<Values>...> pattern,
                      const Values&... values) {
  return filled_in(pattern.text(), {text_value(values)...});
}

// "3, 7-9, 12" of numbers in ascending order.
std::string number_list(const std::vector<int>& numbers);

}  // namespace ribbon
