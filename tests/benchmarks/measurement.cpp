#include "benchmarks/measurement.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <limits>

namespace benchmark {

double quickest_s(double least_s, const std::function<void()>& run) {
  using Clock = std::chrono::steady_clock;
  double quickest = std::numeric_limits<double>::infinity();
  double total = 0;
  for (int runs = 0; runs < 3 || total < least_s; ++runs) {
    const auto start = Clock::now();
    run();
    const double run_s = std::chrono::duration<double>(Clock::now() - start).count();
    quickest = std::min(quickest, run_s);
    total += run_s;
  }
  return quickest;
}

double growth_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  assert(x.size() == y.size() && x.size() >= 2);
  const auto n = static_cast<double>(x.size());
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / n;
    mean_y += std::log(y[i]) / n;
  }
  double xx = 0;
  double xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
    xy += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
  }
  return xy / xx;
}

}  // namespace benchmark
