#include "recording/codec_memory.h"

namespace ribbon {

void CodecMemory::remember_key(LatticeFrame& frame) {
  for (std::size_t c = 0; c < 3; ++c) {
    past[c].position.swap(frame.position[c]);
    grid.replicate_border(past[c].position);
    past[c].motion.assign(grid.size(), 0);
    past[c].older_motion.assign(grid.size(), 0);
  }
  activity.forget();
}

void CodecMemory::remember_delta(LatticeFrame& frame) {
  for (std::size_t c = 0; c < 3; ++c) {
    grid.replicate_border(frame.position[c]);
    past[c].older_motion.swap(past[c].motion);
    for (std::size_t at = 0; at < grid.size(); ++at)
      past[c].motion[at] = wrapping_subtract(frame.position[c][at], past[c].position[at]);
    past[c].position.swap(frame.position[c]);
  }
  activity.remember(frame.residuals);
}

}  // namespace ribbon
