// A disk that fails.
#pragma once

#include <sys/types.h>

namespace ribbon {

// While it lives nothing of any file can be read from that byte on. Programs that are to have it
// compile failing_disk.cpp, which takes the place of the system's pread().
class FailingDisk {
 public:
  explicit FailingDisk(off_t first_lost);
  ~FailingDisk();
  FailingDisk(const FailingDisk&) = delete;
  FailingDisk& operator=(const FailingDisk&) = delete;
};

}  // namespace ribbon
