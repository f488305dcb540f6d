#include <cassert>

#include "recording/codec/frame_loops.h"

namespace ribbon {

extern const FrameLoops baseline_loops;
#ifdef RIBBON_X86_LOOPS
extern const FrameLoops avx2_loops;
extern const FrameLoops avx512_loops;
#endif

const FrameLoops* loops_for(InstructionSet set) {
#ifdef RIBBON_X86_LOOPS
  if (set == InstructionSet::avx2)
    return __builtin_cpu_supports("avx2") != 0 ? &avx2_loops : nullptr;
  if (set == InstructionSet::avx512)
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
                   __builtin_cpu_supports("avx512dq") != 0 &&
                   __builtin_cpu_supports("avx512bw") != 0
               ? &avx512_loops
               : nullptr;
#endif
  return set == InstructionSet::baseline ? &baseline_loops : nullptr;
}

InstructionSet best_instruction_set() {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2})
    if (loops_for(set) != nullptr) return set;
  return InstructionSet::baseline;
}

namespace {

const FrameLoops*& chosen_loops() {
  static const FrameLoops* chosen = loops_for(best_instruction_set());
  return chosen;
}

}  // namespace

const FrameLoops& loops() {
  return *chosen_loops();
}

void choose_instruction_set(InstructionSet set) {
  assert(loops_for(set) != nullptr);
  chosen_loops() = loops_for(set);
}

}  // namespace ribbon
