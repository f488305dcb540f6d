#include "parallel/parallel.h"

#include <gtest/gtest.h>

#include <vector>

namespace ribbon::parallel_test {

TEST(Parallel, every_index_is_visited_once_for_any_number_of_threads) {
  for (const int threads : {1, 2, 7}) {
    set_thread_limit(threads);
    for (const std::size_t count : {0U, 1U, 63U, 64U, 65U, 1000U}) {
      std::vector<int> visits(count, 0);
      parallel_ranges(count, 64, [&](std::size_t begin, std::size_t end) {
        ASSERT_LE(end - begin, 64U);
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
  }
  set_thread_limit(0);
}

}  // namespace ribbon::parallel_test
