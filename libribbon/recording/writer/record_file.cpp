#include "recording/writer/record_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <utility>

#include "files/writer_lock.h"

namespace ribbon {

namespace {

// Pipes and devices cannot be forced to the disk, and need not be.
bool is_on_disk(int answer) {
  return answer == 0 || errno == EINVAL || errno == EROFS;
}

bool holds_anything(const FileDescriptor& file) {
  struct stat status {};
  return ::fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0;
}

// Another file may have taken its name before it was locked.
bool is_still_at(const std::filesystem::path& path, const FileDescriptor& file) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(file.number(), &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

Result<RecordFile> RecordFile::open(const std::filesystem::path& path, int flags) {
  FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666));
  if (!file.is_open() && errno == EEXIST)
    return failure(path.string(), "exists already", "choose another name, or ask to replace it");
  if (!file.is_open())
    return failure(path.string(), "cannot be written (" + last_error_text() + ")",
                   "choose a file that you may write to");
  if (!lock_for_writing(file) || !is_still_at(path, file))
    return failure(path.string(), "is being written by another program",
                   "wait until that has ended, or choose another file");
  return RecordFile(path, std::move(file));
}

Result<RecordFile> RecordFile::create(const std::filesystem::path& path, Overwrite overwrite) {
  if (auto created = create_folder_of(path); !created)
    return tl::unexpected(std::move(created.error()));
  std::error_code code;
  const bool is_file = !std::filesystem::is_other(path, code);
  auto file = open(path, overwrite == Overwrite::no && is_file ? O_CREAT | O_EXCL : O_CREAT);
  if (!file || !holds_anything(file->file_)) return file;
  return file->stand_beside().map([&] { return *std::move(file); });
}

Result<void> RecordFile::stand_beside() {
  auto part = PartFile::create(path_);
  if (!part) return tl::unexpected(part.error());
  part_.emplace(*std::move(part));
  replaced_ = std::exchange(file_, std::move(part_->file()));
  if (!lock_for_writing(file_)) return cannot_be_written(path_);
  return {};
}

Result<void> RecordFile::take_place() {
  if (!part_) return {};
  if (auto synced = sync(); !synced) return synced;
  if (auto taken = part_->take_place_of(path_); !taken) return taken;
  sync_folder_of(path_);
  part_.reset();
  replaced_.close();
  return {};
}

Result<RecordFile> RecordFile::open(const std::filesystem::path& path) {
  auto file = open(path, 0);
  struct stat status {};
  if (!file) return file;
  if (::fstat(file->file_.number(), &status) != 0) return cannot_be_written(path);
  file->size_ = static_cast<std::uint64_t>(status.st_size);
  ::lseek(file->file_.number(), 0, SEEK_END);
  return file;
}

Result<void> RecordFile::check_is_as_written() const {
  struct stat status {};
  if (::fstat(file_.number(), &status) != 0) return {};  // as Emscripten of a file with a new name
  const bool is_whole =
      !S_ISREG(status.st_mode) || static_cast<std::uint64_t>(status.st_size) == size_;
  if (is_whole && is_still_at(present_path(), file_)) return {};
  return failure(path_.string(),
                 "is no longer what was written: somebody has removed, replaced or cut it",
                 "begin anew, and leave the file alone until it is finished");
}

Result<void> RecordFile::append(std::string_view records) {
  assert(file_.is_open() && "not after close()");
  if (write_all(file_, records)) {
    size_ += records.size();
    return {};
  }
  const auto problem = cannot_be_written(path_);
  (void)cut(size_);
  return problem;
}

Result<void> RecordFile::cut(std::uint64_t size) {
  if (::ftruncate(file_.number(), static_cast<off_t>(size)) != 0 ||
      ::lseek(file_.number(), static_cast<off_t>(size), SEEK_SET) < 0)
    return cannot_be_written(path_);
  size_ = size;
  return {};
}

void RecordFile::take_back() {
  if (std::exchange(part_, {})) return;
  std::error_code code;
  if (std::filesystem::is_regular_file(path_, code) && is_still_at(path_, file_))
    ::unlink(linked_file(path_).c_str());
}

Result<void> RecordFile::sync() {
  if (!is_on_disk(::fdatasync(file_.number()))) return may_be_lost();
  if (!std::exchange(name_is_safe_, true)) sync_folder_of(path_);
  return {};
}

Result<void> RecordFile::close() {
  if (!file_.close()) return may_be_lost();
  return {};
}

// Some file systems find out only now that they have no room.
tl::unexpected<Error> RecordFile::may_be_lost() const {
  const std::string reason = last_error_text();
  Error error = cannot_be_written(path_).value();
  error.problem = "may not have reached the disk (" + reason + ")";
  if (!error.may_pass) error.remedy = "check the disk";
  return tl::unexpected(std::move(error));
}

}  // namespace ribbon
