#include "playback/random_access_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "files/writer_lock.h"

namespace ribbon {

namespace {

tl::unexpected<Error> cannot_open(const std::filesystem::path& path, int code) {
  return failure(
      path.string(),
      "cannot be opened (" + std::error_code(code, std::generic_category()).message() + ")",
      "check the name and the permissions");
}

}  // namespace

Result<RandomAccessFile> RandomAccessFile::open(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return cannot_open(path, errno);
  RandomAccessFile file(descriptor, 0);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return cannot_open(path, errno);
  if (!S_ISREG(status.st_mode)) return failure(path.string(), "is not a file", "name a recording");
  file.size_ = static_cast<std::uint64_t>(status.st_size);
  return file;
}

RandomAccessFile::RandomAccessFile(RandomAccessFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

RandomAccessFile& RandomAccessFile::operator=(RandomAccessFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(size_, other.size_);
  return *this;
}

RandomAccessFile::~RandomAccessFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool RandomAccessFile::update_size() {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) return false;
  const auto size = static_cast<std::uint64_t>(status.st_size);
  return std::exchange(size_, size) != size;
}

bool RandomAccessFile::is_being_written() const {
  return is_locked_for_writing(descriptor_);
}

std::string RandomAccessFile::read(std::uint64_t offset, std::uint64_t count) const {
  if (offset >= size_) return {};
  std::string bytes(std::min(count, size_ - offset), '\0');
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t got = ::pread(descriptor_, bytes.data() + filled, bytes.size() - filled,
                                static_cast<off_t>(offset + filled));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    filled += static_cast<std::size_t>(got);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace ribbon
