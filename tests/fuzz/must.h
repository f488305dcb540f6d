// What a fuzz target demands; unlike an assert also of optimised builds.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace ribbon {

inline void must(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "it must hold that %s\n", what);
  std::abort();
}

}  // namespace ribbon
