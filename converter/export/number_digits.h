// Numbers in files of text.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace ribbon {

// The shortest decimals that read back as the same number, whatever the locale.
template <class Number>
void append_digits(std::string& text, Number number) {
  std::array<char, 32> digits{};
  text.append(digits.data(),
              std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

}  // namespace ribbon
