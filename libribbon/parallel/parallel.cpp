#include "parallel/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>

namespace ribbon {

void set_thread_limit(int threads) {
  static std::unique_ptr<tbb::global_control> limit;
  limit.reset();
  if (threads > 0)
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  threads);
}

void parallel_ranges(std::size_t count, std::size_t grain, RangeBody body) {
  if (count <= grain) {
    if (count > 0) body(0, count);
    return;
  }
  const std::size_t ranges = (count + grain - 1) / grain;
  tbb::parallel_for(
      std::size_t{0}, ranges,
      [&](std::size_t range) { body(range * grain, std::min(count, (range + 1) * grain)); },
      tbb::simple_partitioner{});
}

}  // namespace ribbon
