// Loops over lanes that the compiler makes vector instructions of.
#pragma once

#include "parallel/instruction_set.h"

// Stands before a loop over lanes whose rounds do not depend on each other. Clang finds out itself,
// and chooses the width of registers itself.
#ifdef __clang__
#define RIBBON_EACH_LANE
#define RIBBON_EACH_LANE_OF_A_FEW
#define RIBBON_WIDE
#else
#define RIBBON_EACH_LANE _Pragma("GCC ivdep")
// Within another loop: GCC would write so few rounds out before it looks for lanes.
#define RIBBON_EACH_LANE_OF_A_FEW _Pragma("GCC unroll 1")
#define RIBBON_WIDE ",prefer-vector-width=512"
#endif

// Stands behind the parameters of a lambda that vectorised() runs.
#define RIBBON_INLINED __attribute__((always_inline))

namespace ribbon {

#ifdef __x86_64__
template <class Loops>
[[gnu::target("avx2")]] void eight_lanes_at_a_time(const Loops& loops) {
  loops();
}
template <class Loops>
[[gnu::target("avx512f,avx512vl,avx512bw,avx512dq" RIBBON_WIDE)]] void sixteen_lanes_at_a_time(
    const Loops& loops) {
  loops();
}
#endif

// Runs `loops`, a lambda that is always inlined, compiled for the registers of this processor: the
// same bits with each.
template <class Loops>
void vectorised(const Loops& loops) {
#ifdef __x86_64__
  if (instruction_set() == InstructionSet::avx512) return sixteen_lanes_at_a_time(loops);
  if (instruction_set() == InstructionSet::avx2) return eight_lanes_at_a_time(loops);
#endif
  loops();
}

}  // namespace ribbon
