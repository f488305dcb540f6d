#include "player/output/reader_pipe.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <climits>
#include <optional>

namespace ribbon {

namespace {

// Shorter than anybody notices.
constexpr int between_looks_ms = 50;
// Long enough for a program that does read, to which no picture shall come in part.
constexpr std::chrono::seconds moment{1};

}  // namespace

Sent send_all(const FileDescriptor& pipe, std::string_view bytes, const Stopped& stopped) {
  std::optional<std::chrono::steady_clock::time_point> end;
  while (!bytes.empty()) {
    const auto now = std::chrono::steady_clock::now();
    if (!end && stopped && stopped()) end = now + moment;
    if (end && now >= *end) return Sent::given_up;
    pollfd ready{pipe.number(), POLLOUT, 0};
    if (::poll(&ready, 1, between_looks_ms) <= 0) continue;
    // No more than a pipe that is ready takes without waiting.
    const ssize_t written = ::write(pipe.number(), bytes.data(),
                                    std::min(bytes.size(), static_cast<std::size_t>(PIPE_BUF)));
    if (written < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (written <= 0) return Sent::failed;
    bytes.remove_prefix(written);
  }
  return Sent::all;
}

}  // namespace ribbon
