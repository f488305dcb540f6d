// What the system calls an open file, and writing to it without losing anything on the way.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "result/result.h"

namespace ribbon {

// Owns an open file and closes it in the end.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  // Takes what open() returned: below 0, that nothing is open.
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() { close(); }

  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }

  // False where the system says that something may be lost; last_error_text() then tells why.
  bool close();

 private:
  int number_ = -1;
};

// Writes all of `bytes`, in one write() where the system lets us, so that a kill leaves whole
// records. False when it could not; last_error_text() then tells why.
bool write_all(const FileDescriptor& file, std::string_view bytes);

// The system's words for what went wrong last in this thread ("No space left on device").
std::string last_error_text();

// That `path` cannot be written because of what went wrong last in this thread; may pass where
// there is no room.
tl::unexpected<Error> cannot_be_written(const std::filesystem::path& path);

// What a link leads to; `path` itself where that is none, or leads nowhere.
std::filesystem::path linked_file(const std::filesystem::path& path);

// Creates the folder that `path` lies in, and those that this one lies in; none where `path` itself
// names a folder ("new/"), which fails.
Result<void> create_folder_of(const std::filesystem::path& path);

// Waits until the names of files in the folder of linked_file(path) are on the disk, where the file
// system lets us.
void sync_folder_of(const std::filesystem::path& path);

}  // namespace ribbon
