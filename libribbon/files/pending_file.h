// A file written piece by piece, for what is too long to be held in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "files/part_file.h"
#include "result/result.h"

namespace ribbon {

// Stands beside its final name under a temporary one until finish() renames it. Destroyed earlier,
// it leaves nothing behind, and an older file under the name is untouched. Errors name the file
// as the user did.
class PendingFile {
 public:
  // Creates missing parent folders. Fails where a folder, a device or a pipe has that name: a file
  // must not take its place.
  static Result<PendingFile> create(const std::filesystem::path& path);

  // Small pieces wait in memory until they are worth a write, and may fail only then.
  Result<void> append(std::string_view bytes);
  // Replaces bytes that were appended before: what is known only later, as a length in a header.
  // offset: in bytes from the beginning; all of `bytes` must fall on what is there.
  Result<void> overwrite(std::uint64_t offset, std::string_view bytes);
  // Of all that was appended.
  [[nodiscard]] std::uint64_t size() const { return size_; }

  // Forces everything to the disk and renames. Nothing may be written afterwards.
  Result<void> finish(Older older = Older::is_replaced);

 private:
  PendingFile(std::filesystem::path path, PartFile part)
      : path_(std::move(path)), part_(std::move(part)) {}
  Result<void> write_waiting();

  std::filesystem::path path_;
  PartFile part_;
  std::uint64_t size_ = 0;
  std::string waiting_;  // the last of these bytes, not yet in the file
};

}  // namespace ribbon
