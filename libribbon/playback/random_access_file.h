// A file of which any part can be read at any time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include "files/descriptor.h"
#include "result/result.h"

namespace ribbon {

class RandomAccessFile {
 public:
  static Result<RandomAccessFile> open(const std::filesystem::path& path);

  // As it was when opened or when update_size() was called last.
  [[nodiscard]] std::uint64_t size() const { return size_; }

  // How many of these bytes somebody wrote, as far as the system can tell: a file may be mostly
  // holes, which read as zeros and take no room on the disk.
  [[nodiscard]] std::uint64_t written_bytes() const { return written_bytes_; }

  // Has the size changed?
  bool update_size();

  // Does a writer hold the file at this moment?
  [[nodiscard]] bool is_being_written() const;

  // The bytes from `offset` on, `count` of them or as many as there are: fewer at the end, and none
  // where the disk fails.
  [[nodiscard]] std::string read(std::uint64_t offset, std::uint64_t count) const;
  // Has the disk failed, at any time? Then what is missing may be there the next time.
  [[nodiscard]] bool has_failed() const { return has_failed_; }

  // The first byte from `offset` on that somebody wrote, likewise.
  [[nodiscard]] std::uint64_t next_written(std::uint64_t offset) const;

 private:
  explicit RandomAccessFile(FileDescriptor file) : file_(std::move(file)) {}
  [[nodiscard]] std::uint64_t next_hole(std::uint64_t offset) const;
  [[nodiscard]] std::uint64_t written_within(std::uint64_t begin, std::uint64_t end) const;

  FileDescriptor file_;
  std::uint64_t size_ = 0;
  std::uint64_t written_bytes_ = 0;
  mutable bool has_failed_ = false;
};

}  // namespace ribbon
