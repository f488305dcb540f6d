#include "benchmarks/measurement.h"
#include "benchmarks/solver/detection_cost.h"

namespace benchmark {

CostUnit cost_unit() {
  return {"time_s", "ms", 1e3};
}

double cost_of(const std::function<void()>& detect) {
  constexpr double least_s = 0.3;
  return quickest_s(least_s, detect);
}

}  // namespace benchmark
