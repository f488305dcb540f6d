// Folders for tests that write files.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace ribbon {

// Empty, and of nobody else: tests run at the same time in processes of their own. Goes with its
// owner. Its name has a space, which everything must bear.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static int made = 0;
    path_ = std::filesystem::path(testing::TempDir()) /
            ("ribbon test " + std::to_string(::getpid()) + "-" + std::to_string(made++));
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// A path in a folder that goes with this process.
inline std::filesystem::path temporary_file(const std::string& name) {
  static const TemporaryFolder folder;
  return folder.path() / name;
}

// A test with a folder of its own.
class TestInFolder : public testing::Test {
 private:
  TemporaryFolder own_;

 protected:
  const std::filesystem::path& folder_ = own_.path();
};

}  // namespace ribbon
