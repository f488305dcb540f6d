// The file that records are appended to, by one writer at a time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "files/descriptor.h"
#include "files/part_file.h"
#include "result/result.h"

namespace ribbon {

// May a recording take the place of an older file? `yes`: with its first frame; `when_told`: by
// take_place().
enum class Overwrite { no, yes, when_told };

class RecordFile {
 public:
  // Creates `path` and locks it; creates missing parent folders. An older file stays as it is until
  // take_place(). Fails when it is not to be replaced, cannot be written or somebody else is
  // writing it. Pipes and devices hold nothing that could be lost.
  static Result<RecordFile> create(const std::filesystem::path& path,
                                   Overwrite overwrite = Overwrite::yes);

  // Opens and locks an older file, to append to it. Fails likewise.
  static Result<RecordFile> open(const std::filesystem::path& path);

  // Whole records only.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // What it is called at present: otherwise, until take_place().
  [[nodiscard]] const std::filesystem::path& present_path() const {
    return part_ ? part_->path() : path_;
  }

  // Hands whole records to the operating system, in one write(). What a failed one left of them is
  // taken back, so that the file always ends with a whole record.
  Result<void> append(std::string_view records);

  // Fails where the name no longer leads to all that was appended.
  [[nodiscard]] Result<void> check_is_as_written() const;

  // Cuts off what lies behind `size` bytes, which must be a record's end.
  Result<void> cut(std::uint64_t size);

  // From now on this file has the name, and what had it before is gone.
  Result<void> take_place();

  // Takes back what was created, of no use to anybody: its name is free again, and an older file
  // is as it was. Not after take_place() of an older one. Pipes and devices stay.
  void take_back();

  // Waits until everything appended is on the disk.
  Result<void> sync();

  // Closes and unlocks; nothing can be appended afterwards.
  Result<void> close();

 private:
  RecordFile(std::filesystem::path path, FileDescriptor file)
      : path_(std::move(path)), file_(std::move(file)) {}
  static Result<RecordFile> open(const std::filesystem::path& path, int flags);
  Result<void> stand_beside();
  [[nodiscard]] tl::unexpected<Error> may_be_lost() const;

  std::filesystem::path path_;
  FileDescriptor file_;
  FileDescriptor replaced_;       // the older file, locked
  std::optional<PartFile> part_;  // what file_ is called until then
  std::uint64_t size_ = 0;
  bool name_is_safe_ = false;  // the folder's entry is on the disk, too
};

}  // namespace ribbon
