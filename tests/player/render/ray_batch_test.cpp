#include "player/render/ray_batch.h"

#include <gtest/gtest.h>

#include <vector>

#include "parallel/instruction_set.h"

namespace ribbon::ray_batch_test {

std::vector<int> listed(const Lanes<Body>& bodies, Body body, std::size_t count) {
  LaneList list;
  list_marked(bodies, body, count, list);
  return {list.lanes.begin(), list.lanes.begin() + static_cast<std::ptrdiff_t>(list.count)};
}

TEST(MarkedLanes, are_listed_in_order_with_any_instruction_set) {
  Lanes<Body> bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies[i] = static_cast<Body>(i * i % 7 % 3);  // those behind the last count, too
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!is_available(set)) continue;
    choose_instruction_set(set);
    for (const std::size_t count : {0, 1, 15, 16, 17, 100, 256})
      for (const Body body : {Body::none, Body::ribbon, Body::obstacle, Body::ground}) {
        std::vector<int> expected;
        for (std::size_t i = 0; i < count; ++i)
          if (bodies[i] == body) expected.push_back(static_cast<int>(i));
        EXPECT_EQ(listed(bodies, body, count), expected) << count << " lanes";
      }
  }
  choose_instruction_set(best_instruction_set());
}

TEST(MarkedLanes, can_be_all_of_a_batch) {
  Lanes<Body> bodies;
  bodies.fill(Body::ribbon);
  EXPECT_EQ(listed(bodies, Body::ribbon, batch_size).size(), batch_size);
  EXPECT_TRUE(listed(bodies, Body::none, batch_size).empty());
}

}  // namespace ribbon::ray_batch_test
