#include "player/output/raw_frames.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace ribbon {

Result<std::unique_ptr<PictureSink>> RawFrames::open(Stopped stopped) {
  if (::isatty(STDOUT_FILENO) == 1)
    return failure("standard output", "is a terminal, and raw frames are for programs",
                   "pipe them into one, or name a file to write");
  return std::unique_ptr<PictureSink>(new RawFrames(
      FileDescriptor(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0)), std::move(stopped)));
}

Result<void> RawFrames::put(OutputPicture picture) {
  const auto& rgb = std::get<Picture>(picture.image).rgb;
  const Sent sent =
      send_all(output_, {reinterpret_cast<const char*>(rgb.data()), rgb.size()}, stopped_);
  if (sent == Sent::all) return {};
  if (sent == Sent::given_up)
    return passing_failure("standard output", "was not read when it was interrupted",
                           "look at the program that reads it, and run it again");
  if (errno == EPIPE)
    return failure("standard output", "was closed by the program that reads it",
                   "look at what that says");
  return cannot_be_written("standard output");
}

Result<void> RawFrames::finish() {
  if (output_.close()) return {};
  return cannot_be_written("standard output");
}

}  // namespace ribbon
