// How much memory the program holds: every allocation is counted, whoever makes it.
#pragma once

#include <cstddef>

namespace benchmark {

struct HeapUse {
  std::size_t bytes = 0;        // held now, as the allocator rounds them
  std::size_t most_bytes = 0;   // held at any time since the last restart
  std::size_t allocations = 0;  // made since then
};

// Programs that link this have the C library's allocation functions replaced by counting ones.
HeapUse heap_use();

// Forgets what was held before.
void restart_heap_use();

}  // namespace benchmark
