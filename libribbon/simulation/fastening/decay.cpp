#include "simulation/fastening/decay.h"

namespace ribbon {

double decayed(double x) {
  constexpr double small = 1.0 / 32;
  if (x > small) {
    const double half = decayed(x / 2);
    return half * (2 - half);
  }
  // Taylor: x - x^2 / 2! + x^3 / 3! ...; what follows the tenth term is below any rounding.
  double sum = 1;
  for (int term = 10; term > 1; --term) sum = 1 - x / term * sum;
  return x * sum;
}

}  // namespace ribbon
