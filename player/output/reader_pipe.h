// Writing to a program that reads, which may be stuck.
#pragma once

#include <functional>
#include <string_view>

#include "files/descriptor.h"

namespace ribbon {

// Asked again and again while a program is waited for: true once the user wants to end. Empty: it
// is waited for as long as it takes.
using Stopped = std::function<bool()>;

enum class Sent {
  all,
  failed,   // last_error_text() tells why
  given_up  // the user wanted to end, and the program did not take the rest within a moment
};

// To a pipe, or whatever else a program reads from or is a file.
Sent send_all(const FileDescriptor& pipe, std::string_view bytes, const Stopped& stopped);

}  // namespace ribbon
