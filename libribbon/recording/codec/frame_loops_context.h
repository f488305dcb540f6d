// Everything that frame_loops.inc needs, to be included before an instruction set is chosen:
// what is defined in headers must stay as it is for all processors.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#include "recording/codec/frame_loops.h"
