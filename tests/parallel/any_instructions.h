// Answers that the processor's instruction set must not change.
#pragma once

#include <gtest/gtest.h>

#include "parallel/instruction_set.h"

namespace ribbon {

// Expects that compute() gives the same (==) with each set that the processor has; returns it.
template <class Compute>
auto same_for_any_instructions(const Compute& compute) {
  choose_instruction_set(InstructionSet::baseline);
  auto plain = compute();
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    if (!is_available(set)) continue;
    choose_instruction_set(set);
    EXPECT_EQ(compute(), plain) << "set " << static_cast<int>(set);
  }
  choose_instruction_set(best_instruction_set());
  return plain;
}

}  // namespace ribbon
