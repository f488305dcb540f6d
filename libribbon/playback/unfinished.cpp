#include "playback/unfinished.h"

namespace ribbon {

std::string unfinished_text(const RecordingReader& reader) {
  if (reader.finished() && reader.ending() != RunEnding::stopped) return "";
  return "unfinished: it ends with frame " + std::to_string(reader.frame_count()) +
         (reader.is_being_written() ? ", and is still being written"
                                    : ", where its recorder was stopped");
}

}  // namespace ribbon
