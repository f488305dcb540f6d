// Ogawa: the tree of groups and data that an Alembic file is, without what it means.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/pending_file.h"

namespace ribbon {

// Layout (little-endian): "Ogawa", 0xff (0 while it is being written), 0, 1, u64 root group.
// A group: u64 count, u64 children. Data: u64 bytes, bytes.
//
// Children come before the group that holds them. A failure to write is kept until it is asked for,
// by error() or finish(); what is added after it goes nowhere.
class OgawaFile {
 public:
  // How a group names its child: where it begins in the file. The highest bit marks data.
  using Child = std::uint64_t;

  static Result<OgawaFile> create(const std::filesystem::path& path);

  // One after the other as one piece of data.
  Child add_data(std::initializer_list<std::string_view> pieces);
  Child add_group(const std::vector<Child>& children);

  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  Result<void> finish(Child root, Older older);

 private:
  explicit OgawaFile(PendingFile file);
  void append(std::string_view bytes);
  void append_number(std::uint64_t number);

  PendingFile file_;
  std::optional<Error> error_;
};

}  // namespace ribbon
