// Exponential decay with the same bits from any C library.
#pragma once

namespace ribbon {

// 1 - e^-x, x >= 0: what is lost of something that decays. Of exactly rounded operations alone,
// which std::expm1 is not; right to a few units in the 15th digit.
double decayed(double x);

}  // namespace ribbon
