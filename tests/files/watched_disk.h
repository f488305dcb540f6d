// A disk that is watched, and that refuses.
#pragma once

#include <string>
#include <vector>

namespace ribbon {

// While it lives, what is asked of the system is noted, and answered as a test wishes. Programs
// that are to have it compile watched_disk.cpp, which takes the place of the system's calls.
class WatchedDisk {
 public:
  WatchedDisk();
  ~WatchedDisk();
  WatchedDisk(const WatchedDisk&) = delete;
  WatchedDisk& operator=(const WatchedDisk&) = delete;

  // "sync FILE", "link FILE" and "rename FILE" (to that name), in their order; temporary names
  // without their number, all without their folders.
  [[nodiscard]] std::vector<std::string> calls() const;

  // The next calls of that name ("write", "sync", "close", "link" or "rename") fail with this
  // error.
  void refuse(const std::string& call, int error, int times = 1);

  // Writes are interrupted half of the time, and then take no more than a few bytes.
  void dawdle();
};

}  // namespace ribbon
