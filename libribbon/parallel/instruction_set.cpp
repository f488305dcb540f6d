#include "parallel/instruction_set.h"

#include <cassert>
#include <initializer_list>

namespace ribbon {

namespace {

InstructionSet& chosen() {
  static InstructionSet set = best_instruction_set();
  return set;
}

}  // namespace

bool is_available([[maybe_unused]] InstructionSet set) {
#ifdef __x86_64__
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2") != 0;
  if (set == InstructionSet::avx512)
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
           __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0;
#endif
  return set == InstructionSet::baseline;
}

InstructionSet best_instruction_set() {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2})
    if (is_available(set)) return set;
  return InstructionSet::baseline;
}

InstructionSet instruction_set() {
  return chosen();
}

void choose_instruction_set(InstructionSet set) {
  assert(is_available(set));
  chosen() = set;
}

}  // namespace ribbon
