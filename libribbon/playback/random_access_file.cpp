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
  RandomAccessFile opened(std::move(file));
  opened.update_size();
  return opened;
}

bool RandomAccessFile::update_size() {
  struct stat status {};
  if (::fstat(file_.number(), &status) != 0) return false;
  const auto size = static_cast<std::uint64_t>(status.st_size);
  const std::uint64_t before = std::exchange(size_, size);
  if (size == before) return false;
  written_bytes_ =
      size < before ? written_within(0, size) : written_bytes_ + written_within(before, size);
  return true;
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
    if (got < 0) has_failed_ = true;
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

// Behind all that somebody wrote from `offset` on in one piece; the end where the system cannot
// tell.
std::uint64_t RandomAccessFile::next_hole(std::uint64_t offset) const {
#ifdef SEEK_HOLE
  const off_t found = ::lseek(file_.number(), static_cast<off_t>(offset), SEEK_HOLE);
  if (found > static_cast<off_t>(offset)) return static_cast<std::uint64_t>(found);
#endif
  return std::max(offset, size_);
}

std::uint64_t RandomAccessFile::written_within(std::uint64_t begin, std::uint64_t end) const {
  std::uint64_t bytes = 0;
  while ((begin = next_written(begin)) < end) {
    const std::uint64_t hole = std::min(next_hole(begin), end);
    bytes += hole - begin;
    begin = hole;
  }
  return bytes;
}

}  // namespace ribbon
