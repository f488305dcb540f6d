#include <gtest/gtest.h>

#include <cstddef>

#include "benchmarks/heap_use.h"
#include "simulation/detection/book.h"
#include "simulation/detection/triangle_bvh.h"

namespace ribbon::triangle_bvh_memory_test {

std::size_t most_bytes_of(const Book& book) {
  const CollisionSurface surface = collision_surface(book.triangles);
  benchmark::restart_heap_use();
  const std::size_t before = benchmark::heap_use().bytes;
  const TriangleBvh bvh(surface, book.vertices);
  return benchmark::heap_use().most_bytes - before;
}

// And so does its time, for what is taken is gone through. Of four times as many triangles, since
// buffers double: less than eight times the memory, where all pairs of them would take sixteen.
TEST(TriangleBvhMemory, grows_as_the_number_of_triangles_at_an_edge_does) {
  for (const bool all_copies : {false, true}) {
    SCOPED_TRACE(all_copies);
    EXPECT_LT(most_bytes_of(Book(400, all_copies ? 1 : 400)),
              8 * most_bytes_of(Book(100, all_copies ? 1 : 100)));
  }
}

}  // namespace ribbon::triangle_bvh_memory_test
