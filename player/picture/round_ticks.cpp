#include "player/picture/round_ticks.h"

#include <algorithm>
#include <cmath>

#include "text/number_text.h"

namespace ribbon {

namespace {

struct Step {
  double factor;  // 1, 2 or 5
  int power;      // of ten

  [[nodiscard]] double size() const { return factor * std::pow(10.0, power); }
  [[nodiscard]] Step next() const {
    if (factor == 1) return {2, power};
    if (factor == 2) return {5, power};
    return {1, power + 1};
  }
};

// Ends that are multiples but for rounding count.
constexpr double slack = 1e-9;

// Which multiples of a step lie between low and high.
struct Multiples {
  double first;
  double last;

  Multiples(double low, double high, const Step& step)
      : first(std::ceil(low / step.size() - slack)), last(std::floor(high / step.size() + slack)) {}
  [[nodiscard]] double count() const { return last - first + 1; }
};

}  // namespace

std::string Ticks::text(double value) const {
  return decimals(value, digits);
}

Ticks round_ticks(double low, double high, int most) {
  Ticks ticks;
  const double range = high - low;
  // Where rounding eats the steps, or they cannot be told, there is nothing to write.
  if (!(range > 1e-9 * std::max(std::abs(low), std::abs(high))) || !std::isfinite(range) ||
      range < 1e-300)
    return ticks;
  Step step{1, static_cast<int>(std::floor(std::log10(range / most)))};
  while (Multiples(low, high, step).count() > most) step = step.next();
  const Multiples multiples(low, high, step);
  for (int k = 0; k < multiples.count(); ++k)
    ticks.values.push_back((multiples.first + k) * step.size() + 0.0);  // no minus before 0
  ticks.digits = std::max(0, -step.power);
  return ticks;
}

}  // namespace ribbon
