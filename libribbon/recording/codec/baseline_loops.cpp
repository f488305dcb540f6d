#include "recording/codec/frame_loops_context.h"

namespace ribbon {
extern const FrameLoops baseline_loops;
}

#define RIBBON_LANES 4
#define RIBBON_LOOPS baseline_loops
#include "recording/codec/frame_loops.inc"
