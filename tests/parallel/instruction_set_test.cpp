#include "parallel/instruction_set.h"

#include <gtest/gtest.h>

namespace ribbon::instruction_set_test {

TEST(InstructionSets, the_best_is_used_unless_another_is_chosen) {
  EXPECT_TRUE(is_available(best_instruction_set()));
  EXPECT_EQ(instruction_set(), best_instruction_set());
  ASSERT_TRUE(is_available(InstructionSet::baseline));
  choose_instruction_set(InstructionSet::baseline);
  EXPECT_EQ(instruction_set(), InstructionSet::baseline);
  choose_instruction_set(best_instruction_set());
}

}  // namespace ribbon::instruction_set_test
