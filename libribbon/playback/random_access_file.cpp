#include "playback/random_access_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "files/writer_lock.h"

namespace ribbon {

namespace {

tl::unexpected<Error> cannot_open(const std::filesystem::path& path) {
  return failure(path.string(), "cannot be opened (" + last_error_text() + ")",
                 "check the name and the permissions");
}

}  // namespace

Result<RandomAccessFile> RandomAccessFile::open(const std::filesystem::path& path) {
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (!file.is_open() || ::fstat(file.number(), &status) != 0) return cannot_open(path);
  if (!S_ISREG(status.st_mode)) return failure(path.string(), "is not a file", "name a recording");
  return RandomAccessFile(std::move(file), static_cast<std::uint64_t>(status.st_size));
}

bool RandomAccessFile::update_size() {
  struct stat status {};
  if (::fstat(file_.number(), &status) != 0) return false;
  const auto size = static_cast<std::uint64_t>(status.st_size);
  return std::exchange(size_, size) != size;
}

bool RandomAccessFile::is_being_written() const {
  return is_locked_for_writing(file_);
}

std::string RandomAccessFile::read(std::uint64_t offset, std::uint64_t count) const {
  if (offset >= size_) return {};
  std::string bytes(static_cast<std::size_t>(std::min(count, size_ - offset)), '\0');
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t got = ::pread(file_.number(), bytes.data() + filled, bytes.size() - filled,
                                static_cast<off_t>(offset + filled));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    filled += got;
  }
  bytes.resize(filled);
  return bytes;
}

std::uint64_t RandomAccessFile::next_written(std::uint64_t offset) const {
#ifdef SEEK_DATA
  const off_t found = ::lseek(file_.number(), static_cast<off_t>(offset), SEEK_DATA);
  if (found >= 0) return static_cast<std::uint64_t>(found);
  if (errno == ENXIO) return std::max(offset, size_);
#endif
  return offset;
}

}  // namespace ribbon
