#include <atomic>

#include "benchmarks/solver/detection_cost.h"
#include "geometry/box.h"

namespace {

std::atomic<std::size_t>& tests_made() {
  static std::atomic<std::size_t> made = 0;
  return made;
}

}  // namespace

void ribbon::count_box_test() {
  tests_made().fetch_add(1, std::memory_order_relaxed);
}

namespace benchmark {

CostUnit cost_unit() {
  return {"box_tests", "tests", 1};
}

double cost_of(const std::function<void()>& detect) {
  const std::size_t before = tests_made();
  detect();
  return static_cast<double>(tests_made() - before);
}

}  // namespace benchmark
