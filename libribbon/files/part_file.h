// A file that is not whole yet, beside the one whose place it is to take.
#pragma once

#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "files/descriptor.h"
#include "result/result.h"

namespace ribbon {

// What stands in a temporary name behind the final one, before a number.
constexpr std::string_view temporary_mark = ".part";

// What to do with a file that has the name already.
enum class Older { is_replaced, stays };

// Is gone in the end unless it has taken that place. A kill may leave it behind.
class PartFile {
 public:
  // Creates a file that nobody else has, not even a process of the same number on another machine
  // or in another container; beside the file itself where `whole` is a link to one. Creates missing
  // parent folders. Errors name `whole`.
  static Result<PartFile> create(const std::filesystem::path& whole);

  PartFile(PartFile&& other) noexcept
      : path_(std::exchange(other.path_, {})), file_(std::move(other.file_)) {}
  PartFile& operator=(PartFile&& other) noexcept {
    path_.swap(other.path_);
    file_ = std::move(other.file_);
    return *this;
  }
  ~PartFile();

  // Of the temporary name; empty once it has taken the place.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // Open for reading and writing.
  [[nodiscard]] FileDescriptor& file() { return file_; }

  // Renames it to `whole`, which may exist, in one step: that name has the older file or this one
  // at any moment. Links go on to lead there, and the permissions stay what they were.
  // sync_folder_of() brings the name to the disk. On failure both are as they were; it may pass
  // where somebody has removed this one, taking it for what a kill left. Where an older
  // file stays, this one does so, too, under its temporary name, which the error tells: it may have
  // taken hours.
  Result<void> take_place_of(const std::filesystem::path& whole, Older older = Older::is_replaced);

 private:
  Result<void> take_free_place(const std::filesystem::path& whole);

  PartFile(std::filesystem::path path, FileDescriptor file)
      : path_(std::move(path)), file_(std::move(file)) {}

  std::filesystem::path path_;
  FileDescriptor file_;
};

// Removes what a kill has left of `files` under temporary names. Nobody knows whether a process
// still writes one of these: write_file() tries once more then.
void remove_leftovers(const std::vector<std::filesystem::path>& files);

}  // namespace ribbon
