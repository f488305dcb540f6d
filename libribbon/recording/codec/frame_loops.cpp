#include "recording/codec/frame_loops.h"

#include "parallel/instruction_set.h"

namespace ribbon {

extern const FrameLoops baseline_loops;
#ifdef __x86_64__
extern const FrameLoops avx2_loops;
extern const FrameLoops avx512_loops;
#endif

const FrameLoops& loops() {
#ifdef __x86_64__
  if (instruction_set() == InstructionSet::avx512) return avx512_loops;
  if (instruction_set() == InstructionSet::avx2) return avx2_loops;
#endif
  return baseline_loops;
}

}  // namespace ribbon
