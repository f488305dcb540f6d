#ifdef __x86_64__
#include "recording/codec/frame_loops_context.h"

namespace ribbon {
extern const FrameLoops avx512_loops;
}

#define RIBBON_LANES 16
#define RIBBON_LOOPS avx512_loops
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx512f,avx512vl,avx512bw,avx512dq"))), \
                             apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f,avx512vl,avx512bw,avx512dq")
#endif
#include "recording/codec/frame_loops.inc"
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
