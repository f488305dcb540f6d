// For WebAssembly: a page that was opened from a disk has no threads.
#include <algorithm>

#include "parallel/parallel.h"

namespace ribbon {

void set_thread_limit(int /*threads*/) {}

void parallel_ranges(std::size_t count, std::size_t grain, RangeBody body) {
  for (std::size_t begin = 0; begin < count; begin += grain)
    body(begin, std::min(count, begin + grain));
}

}  // namespace ribbon
