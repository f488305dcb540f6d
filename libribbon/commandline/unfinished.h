// A recording that has no end yet, in words.
#pragma once

#include <string>

namespace ribbon {

// One sentence, without its full stop, for who shows or converts a recording up to its last frame:
// "the recording is unfinished: it ends with frame 50, where its recorder was stopped".
std::string unfinished_text(int last_frame, bool is_being_written);

}  // namespace ribbon
