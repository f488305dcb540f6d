#include "inspection/unfinished.h"

#include "text/number_text.h"

namespace ribbon {

std::string unfinished_text(const RecordingReader& reader) {
  if (reader.finished()) return "";
  return filled_in("unfinished: ends with frame {}", reader.frame_count());
}

}  // namespace ribbon
