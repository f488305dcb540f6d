// What is drawn over pictures when it is asked for.
#pragma once

#include <string>

#include "result/result.h"

namespace ribbon {

struct Overlays {
  bool wireframe = false;  // of the ribbon
  bool obstacle_wireframe = false;
  bool curve = false;  // that the ribbon was put on, where the recording tells it
  bool frame = false;  // its number
  bool time = false;
  bool numbers = false;  // strain, and how tight the ribbon is

  [[nodiscard]] bool has_caption() const { return frame || time || numbers; }
};

// Reads words with commas between them, as in "wireframe,frame,time".
Result<Overlays> parse_overlays(const std::string& text);

}  // namespace ribbon
