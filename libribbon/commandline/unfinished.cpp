#include "commandline/unfinished.h"

#include "text/number_text.h"

namespace ribbon {

std::string unfinished_text(int last_frame, bool is_being_written) {
  return filled_in(
      "the recording is unfinished: it ends with frame {}, {}", last_frame,
      is_being_written ? "and is still being written" : "where its recorder was stopped");
}

}  // namespace ribbon
