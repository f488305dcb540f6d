// The name of a file that is not whole yet.
#pragma once

#include <filesystem>

namespace ribbon {

// Beside `whole`, of this process alone. A file of that name goes in the end unless it has taken
// the place of the whole one. A kill may leave it behind.
class PartFile {
 public:
  explicit PartFile(const std::filesystem::path& whole);
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace ribbon
