// Linked with boxes that count.
#include <atomic>

#include "benchmarks/solver/box_tests_made.h"
#include "geometry/box.h"

namespace ribbon {

namespace {

std::atomic<std::size_t>& tests() {
  static std::atomic<std::size_t> made = 0;
  return made;
}

}  // namespace

void count_box_test() {
  tests().fetch_add(1, std::memory_order_relaxed);
}

std::size_t box_tests_made() {
  return tests();
}

}  // namespace ribbon
