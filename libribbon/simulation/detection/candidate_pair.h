// What a detection tests further.
#pragma once

namespace ribbon {

// Two triangles that may meet.
struct CandidatePair {
  int a = 0;
  int b = 0;
};

}  // namespace ribbon
