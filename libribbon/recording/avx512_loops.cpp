#include "recording/component_loops_context.h"

namespace ribbon {
extern const Loops avx512_loops;
}

#define RIBBON_LOOPS avx512_loops
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx512f,avx512vl,avx512bw,avx512dq"))), \
                             apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f,avx512vl,avx512bw,avx512dq,prefer-vector-width=256")
#endif
#include "recording/component_loops.inc"
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
