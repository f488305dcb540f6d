#include "files/failing_disk.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>

namespace ribbon {

namespace {

constexpr off_t nothing = std::numeric_limits<off_t>::max();
off_t lost_from = nothing;

}  // namespace

FailingDisk::FailingDisk(off_t first_lost) {
  lost_from = first_lost;
}

FailingDisk::~FailingDisk() {
  lost_from = nothing;
}

}  // namespace ribbon

extern "C" ssize_t pread(int file, void* bytes, size_t count, off_t offset) {
  if (offset >= ribbon::lost_from) {
    errno = EIO;
    return -1;
  }
  const auto readable = static_cast<size_t>(ribbon::lost_from - offset);
  return ::syscall(SYS_pread64, file, bytes, std::min(count, readable), offset);
}
