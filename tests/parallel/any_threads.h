// Answers that the number of threads must not change.
#pragma once

#include <gtest/gtest.h>

#include "parallel/parallel.h"

namespace ribbon {

// Expects that compute() gives the same (==) with one thread, two and five; returns it.
template <class Compute>
auto same_for_any_threads(const Compute& compute) {
  set_thread_limit(1);
  auto alone = compute();
  for (const int threads : {2, 5}) {
    set_thread_limit(threads);
    EXPECT_EQ(compute(), alone) << threads << " threads";
  }
  set_thread_limit(0);
  return alone;
}

}  // namespace ribbon
