#include "files/writer_lock.h"

#include <fcntl.h>

#include <cerrno>

namespace ribbon {

namespace {

// Locks of the open file, not of the process: they also keep apart two writers in one process, and
// closing another descriptor of the file does not drop them.
struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

}  // namespace

bool lock_for_writing(const FileDescriptor& file) {
  struct flock lock = whole_file();
  return ::fcntl(file.number(), F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES);
}

bool is_locked_for_writing(const FileDescriptor& file) {
  struct flock lock = whole_file();
  return ::fcntl(file.number(), F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

}  // namespace ribbon
