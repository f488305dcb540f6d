// How previews are drawn.
#pragma once

namespace ribbon {

struct PreviewSettings {
  bool antialiased = true;  // edges with four samples a pixel
  int threads = 0;          // at most so many; 0: as many as there are cores
};

}  // namespace ribbon
