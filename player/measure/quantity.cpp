#include "player/measure/quantity.h"

#include <charconv>
#include <cmath>
#include <optional>

namespace ribbon {

namespace {

std::optional<double> read_number(std::string_view text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, number);
  if (problem != std::errc() || stop != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

}  // namespace

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
  const auto low = read_number(std::string_view(text).substr(0, colon));
  const auto high = read_number(std::string_view(text).substr(colon + 1));
  if (!low || !high) return refusal("is not a range");
  if (!(*low < *high)) return refusal("does not end above its beginning");
  if (*low < 0) return refusal("holds negative values, and there are none");
  if (quantity == Quantity::contact && *low != 0)
    return refusal("begins above 0, and what is nearer touches too");
  return ValueRange{*low, *high};
}

}  // namespace ribbon
