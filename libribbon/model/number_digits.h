// Numbers in files of text.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <type_traits>

#include "model/float_digits.h"

namespace ribbon {

// The shortest decimals that read back as the same number, whatever the locale.
template <class Number>
void append_digits(std::string& text, Number number) {
  std::array<char, 32> digits;
  char* end = nullptr;
  if constexpr (std::is_same_v<Number, float>)
    end = write_digits(digits.data(), number);
  else
    end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

}  // namespace ribbon
