// What a ribbon can be coloured by.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "result/result.h"

namespace ribbon {

enum class Quantity { strain, speed, contact, gap };

// As users write them, in the order of Quantity.
inline constexpr std::array<std::string_view, 4> quantity_words = {"strain", "speed", "contact",
                                                                   "gap"};

// How values of a quantity are told.
struct QuantityNotation {
  const char* title;
  const char* unit;
  double factor;  // from what is measured (a fraction, m/s, m) to that unit
};
QuantityNotation notation(Quantity quantity);

// In the unit of the quantity's notation; low < high, both finite.
struct ValueRange {
  double low = 0;
  double high = 1;

  bool operator==(const ValueRange&) const = default;
};

// Reads "A:B". Distances are not negative, and contact begins at 0: what is nearer than B touches.
Result<ValueRange> parse_color_range(const std::string& text, Quantity quantity);

}  // namespace ribbon
