// The codec of recordings, as a row among others.
#pragma once

#include "benchmarks/codec/frame_codec.h"

namespace ribbon {

CodecRow own_row();

}  // namespace ribbon
