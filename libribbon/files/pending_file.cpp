#include "files/pending_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>

namespace ribbon {

namespace {

constexpr std::size_t worth_a_write = 1 << 16;

}  // namespace

Result<PendingFile> PendingFile::create(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::exists(path, code) && !std::filesystem::is_regular_file(path, code))
    return failure(path.string(), "is a folder, a device or a pipe, not a file",
                   "choose another name");
  if (auto created = create_folder_of(path); !created) return tl::unexpected(created.error());
  std::filesystem::path temporary =
      path.string() + std::string(temporary_mark) + std::to_string(::getpid());
  FileDescriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!file.is_open()) return cannot_be_written(path);
  return PendingFile(path, std::move(temporary), std::move(file));
}

PendingFile::PendingFile(std::filesystem::path path, std::filesystem::path temporary,
                         FileDescriptor file)
    : path_(std::move(path)), temporary_(std::move(temporary)), file_(std::move(file)) {}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      file_(std::move(other.file_)),
      size_(other.size_),
      waiting_(std::move(other.waiting_)) {}

PendingFile::~PendingFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

Result<void> PendingFile::append(std::string_view bytes) {
  size_ += bytes.size();
  if (waiting_.size() + bytes.size() < worth_a_write) {
    waiting_ += bytes;
    return {};
  }
  if (auto written = write_waiting(); !written) return written;
  if (!write_all(file_, bytes)) return cannot_be_written(path_);
  return {};
}

Result<void> PendingFile::write_waiting() {
  if (!write_all(file_, waiting_)) return cannot_be_written(path_);
  waiting_.clear();
  return {};
}

Result<void> PendingFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  assert(offset + bytes.size() <= size_);
  if (auto written = write_waiting(); !written) return written;
  while (!bytes.empty()) {
    const ssize_t written =
        ::pwrite(file_.number(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return cannot_be_written(path_);
    offset += static_cast<std::uint64_t>(written);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

Result<void> PendingFile::finish() {
  if (auto written = write_waiting(); !written) return written;
  // Forced to the disk before the rename: a power cut must not leave an empty file under the name.
  if (::fsync(file_.number()) != 0) return cannot_be_written(path_);
  if (!file_.close()) return cannot_be_written(path_);
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) return cannot_be_written(path_);
  temporary_.clear();
  return {};
}

}  // namespace ribbon
