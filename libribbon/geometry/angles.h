// Angles with the same bits from any C library: of exactly rounded operations alone, which std::sin
// and its kin are not. Angles are in radians.
#pragma once

namespace ribbon {

// Right to 4e-16 for angles from -1e6 to 1e6; no number beyond.
double cosine(double angle);
double sine(double angle);

// Of the direction (x, y), counter-clockwise from that of x: above -pi, at most pi; 0 where both
// are 0. Right to 1e-15 of itself. Neither may be so large that its square is no number.
double polar_angle(double x, double y);

}  // namespace ribbon
