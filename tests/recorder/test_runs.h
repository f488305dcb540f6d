// Runs as tests ask for them.
#pragma once

#include "recorder/run/run.h"

namespace ribbon {

inline const RunObserver goes_on{[](int, int, const FrameNumbers&) { return true; }};

inline RunObserver stops_at(int frames) {
  return {[frames](int done, int, const FrameNumbers&) { return done < frames; }};
}

// A recording that replaces what an earlier part of the same test has left.
inline NewRecording replacing(const std::filesystem::path& file) {
  return {.file = file, .program = "test", .overwrite = Overwrite::yes};
}

}  // namespace ribbon
