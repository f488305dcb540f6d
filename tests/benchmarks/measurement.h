// Measuring times and how they grow.
#pragma once

#include <functional>
#include <vector>

namespace benchmark {

// Seconds of the quickest of at least three runs that together take at least `least_s`.
double quickest_s(double least_s, const std::function<void()>& run);

// The exponent e of y = c x^e by least squares over the logarithms. x, y > 0, at least two.
double growth_exponent(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace benchmark
