// Loops over both cores whose results do not depend on how many there are.
#pragma once

#include <cstddef>
#include <functional>

namespace ribbon {

// Limits all parallel loops of the process to `threads` (0: all cores, the default).
void set_thread_limit(int threads);

// Calls body(begin, end) for consecutive ranges that cover [0, count). The ranges are at most
// `grain` long and depend on count and grain alone, never on the number of threads: a body that
// writes only to slots of its own range gives the same bits for any number of threads.
void parallel_ranges(std::size_t count, std::size_t grain,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace ribbon
