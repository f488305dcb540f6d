#include "recording/writer/record_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>

#include "files/descriptor.h"
#include "files/writer_lock.h"

namespace ribbon {

namespace {

Result<void> create_folder_of(const std::filesystem::path& path) {
  std::error_code code;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), code);
  if (code)
    return failure(path.parent_path().string(), "cannot be created (" + code.message() + ")",
                   "choose a folder that you may write to");
  return {};
}

// Pipes and devices cannot be forced to the disk, and need not be.
bool is_on_disk(int answer) {
  return answer == 0 || errno == EINVAL || errno == EROFS;
}

// Another file may have taken its name before it was locked.
bool is_still_at(const std::filesystem::path& path, int descriptor) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

RecordFile::RecordFile(std::filesystem::path path, int descriptor)
    : path_(std::move(path)), descriptor_(descriptor) {}

RecordFile::RecordFile(RecordFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      name_is_safe_(other.name_is_safe_) {}

RecordFile& RecordFile::operator=(RecordFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(size_, other.size_);
  std::swap(name_is_safe_, other.name_is_safe_);
  return *this;
}

RecordFile::~RecordFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<RecordFile> RecordFile::open(const std::filesystem::path& path, int flags) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
  if (descriptor < 0)
    return failure(path.string(), "cannot be written (" + last_error_text() + ")",
                   "choose a file that you may write to");
  RecordFile file(path, descriptor);
  if (!lock_for_writing(descriptor) || !is_still_at(path, descriptor))
    return failure(path.string(), "is being written by another program",
                   "wait until that has ended, or choose another file");
  return file;
}

Result<RecordFile> RecordFile::create(const std::filesystem::path& path) {
  if (auto created = create_folder_of(path); !created)
    return tl::unexpected(std::move(created.error()));
  auto file = open(path, O_CREAT);
  // Emptied only now that nobody else writes it. Pipes and devices are empty anyway.
  if (file && ::ftruncate(file->descriptor_, 0) != 0 && errno != EINVAL)
    return file->cannot_be_written(last_error_text());
  return file;
}

Result<RecordFile> RecordFile::open(const std::filesystem::path& path) {
  auto file = open(path, 0);
  struct stat status {};
  if (!file) return file;
  if (::fstat(file->descriptor_, &status) != 0) return file->cannot_be_written(last_error_text());
  file->size_ = static_cast<std::uint64_t>(status.st_size);
  ::lseek(file->descriptor_, 0, SEEK_END);
  return file;
}

Result<void> RecordFile::append(std::string_view records) {
  assert(descriptor_ >= 0 && "not after close()");
  if (write_all(descriptor_, records)) {
    size_ += records.size();
    return {};
  }
  const std::string reason = last_error_text();
  (void)cut(size_);
  return cannot_be_written(reason);
}

Result<void> RecordFile::cut(std::uint64_t size) {
  if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0 ||
      ::lseek(descriptor_, static_cast<off_t>(size), SEEK_SET) < 0)
    return cannot_be_written(last_error_text());
  size_ = size;
  return {};
}

Result<void> RecordFile::sync() {
  if (!is_on_disk(::fdatasync(descriptor_))) return may_be_lost(last_error_text());
  if (!std::exchange(name_is_safe_, true)) sync_folder_of(path_);
  return {};
}

Result<void> RecordFile::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) return may_be_lost(last_error_text());
  return {};
}

tl::unexpected<Error> RecordFile::cannot_be_written(const std::string& reason) const {
  return failure(path_.string(), "cannot be written (" + reason + ")",
                 "free some space or choose another place");
}

tl::unexpected<Error> RecordFile::may_be_lost(const std::string& reason) const {
  return failure(path_.string(), "may not have reached the disk (" + reason + ")",
                 "check the disk");
}

}  // namespace ribbon
