#ifdef __x86_64__
#include "recording/codec/frame_loops_context.h"

namespace ribbon {
extern const FrameLoops avx2_loops;
}

#define RIBBON_LANES 8
#define RIBBON_LOOPS avx2_loops
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
#include "recording/codec/frame_loops.inc"
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
