// The file that records are appended to, by one writer at a time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <utility>

#include "files/descriptor.h"
#include "result/result.h"

namespace ribbon {

// May a new file take the place of an older one?
enum class Overwrite { no, yes };

class RecordFile {
 public:
  // Creates `path`, or empties an older file if that is wanted, and locks it; creates missing
  // parent folders. Fails, and leaves an older file as it is, when it cannot be written or somebody
  // else is writing it. Pipes and devices hold nothing that could be lost.
  static Result<RecordFile> create(const std::filesystem::path& path,
                                   Overwrite overwrite = Overwrite::yes);

  // Opens and locks an older file, to append to it. Fails likewise.
  static Result<RecordFile> open(const std::filesystem::path& path);

  // Whole records only.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  // Hands whole records to the operating system, in one write(). What a failed one left of them is
  // taken back, so that the file always ends with a whole record.
  Result<void> append(std::string_view records);

  // Cuts off what lies behind `size` bytes, which must be a record's end.
  Result<void> cut(std::uint64_t size);

  // Takes back a file in which nothing is, so that its name is free again. Pipes and devices stay.
  void remove_if_empty();

  // Waits until everything appended is on the disk.
  Result<void> sync();

  // Closes and unlocks; nothing can be appended afterwards.
  Result<void> close();

 private:
  RecordFile(std::filesystem::path path, FileDescriptor file)
      : path_(std::move(path)), file_(std::move(file)) {}
  static Result<RecordFile> open(const std::filesystem::path& path, int flags);
  [[nodiscard]] tl::unexpected<Error> may_be_lost() const;

  std::filesystem::path path_;
  FileDescriptor file_;
  std::uint64_t size_ = 0;
  bool name_is_safe_ = false;  // the folder's entry is on the disk, too
};

}  // namespace ribbon
