#include "player/measure/quantity.h"

#include <cmath>
#include <string_view>

#include "text/number_in.h"

namespace ribbon {

QuantityNotation notation(Quantity quantity) {
  switch (quantity) {
    case Quantity::strain:
      return {"strain", "%", 100};
    case Quantity::speed:
      return {"speed", "m/s", 1};
    case Quantity::contact:
      return {"contact", "mm", 1000};
    case Quantity::gap:
      break;
  }
  return {"gap to the next layer", "mm", 1000};
}

Result<ValueRange> parse_color_range(const std::string& text, Quantity quantity) {
  const std::string unit = notation(quantity).unit;
  const auto refusal = [&](const std::string& problem) {
    return failure("--color-range " + text, problem,
                   "write A:B with A below B, both in " + unit + ", as in 0:5");
  };
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return refusal("is not a range");
  const auto low = number_in<double>(std::string_view(text).substr(0, colon));
  const auto high = number_in<double>(std::string_view(text).substr(colon + 1));
  if (!low || !high || !std::isfinite(*low) || !std::isfinite(*high))
    return refusal("is not a range");
  if (!(*low < *high)) return refusal("does not end above its beginning");
  if (*low < 0) return refusal("holds negative values, and there are none");
  if (quantity == Quantity::contact && *low != 0)
    return refusal("begins above 0, and what is nearer touches too");
  return ValueRange{*low, *high};
}

}  // namespace ribbon
