#include "recording/component_loops_context.h"

namespace ribbon {
extern const Loops baseline_loops;
}

#define RIBBON_LOOPS baseline_loops
#include "recording/component_loops.inc"
