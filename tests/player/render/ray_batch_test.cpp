#include "player/render/ray_batch.h"

#include <gtest/gtest.h>

#include <vector>

#include "parallel/instruction_set.h"

namespace ribbon::ray_batch_test {

std::vector<int> listed(const Lanes<Body>& bodies, Body body, std::size_t count) {
  MarkedLanes list;
  list_marked(bodies, body, count, list);
  return {list.lanes.begin(), list.lanes.begin() + static_cast<std::ptrdiff_t>(list.count)};
}

// Some of each body but the ground, behind any count of them, too.
Lanes<Body> some_bodies() {
  Lanes<Body> bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i] = static_cast<Body>(i * i % 7 % 3);
  return bodies;
}

// Calls check(body, count) with each body and with counts that fill registers or do not, for each
// instruction set of this processor.
template <class Check>
void with_any_instruction_set(const Check& check) {
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!is_available(set)) continue;
    choose_instruction_set(set);
    for (const std::size_t count : {0, 1, 15, 16, 17, 100, 256})
      for (const Body body : {Body::none, Body::ribbon, Body::obstacle, Body::ground})
        check(body, count);
  }
  choose_instruction_set(best_instruction_set());
}

TEST(MarkedLanes, are_listed_in_order_with_any_instruction_set) {
  const Lanes<Body> bodies = some_bodies();
  with_any_instruction_set([&](Body body, std::size_t count) {
    std::vector<int> expected;
    for (std::size_t i = 0; i < count; ++i)
      if (bodies[i] == body) expected.push_back(static_cast<int>(i));
    EXPECT_EQ(listed(bodies, body, count), expected) << count << " lanes";
  });
}

TEST(MarkedLanes, can_be_all_of_a_batch) {
  Lanes<Body> bodies;
  bodies.fill(Body::ribbon);
  EXPECT_EQ(listed(bodies, Body::ribbon, batch_size).size(), batch_size);
  EXPECT_TRUE(listed(bodies, Body::none, batch_size).empty());
}

TEST(MarkedLanes, are_moved_together_and_apart_with_any_instruction_set) {
  const Lanes<Body> bodies = some_bodies();
  Lanes<float> numbers;
  Lanes<std::uint32_t> whole_numbers;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    whole_numbers[i] = static_cast<std::uint32_t>(1000 + i);
    numbers[i] = static_cast<float>(whole_numbers[i]);
  }
  with_any_instruction_set([&](Body body, std::size_t count) {
    MarkedLanes marked;
    list_marked(bodies, body, count, marked);
    Lanes<float> together{};
    Lanes<std::uint32_t> whole_together{};
    move_together(numbers, marked, together.data());
    move_together(whole_numbers, marked, whole_together.data());
    for (std::size_t i = 0; i < marked.count; ++i) {
      EXPECT_EQ(together[i], numbers[marked.lanes[i]]);
      EXPECT_EQ(whole_together[i], whole_numbers[marked.lanes[i]]);
    }
    Lanes<float> apart;
    move_apart(together, marked, apart);
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_EQ(apart[i], bodies[i] == body ? numbers[i] : 0.0F) << "lane " << i;
  });
}

}  // namespace ribbon::ray_batch_test
