// Which files of a sequence are complete, remembered beside them until all are.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "files/descriptor.h"
#include "result/result.h"

namespace ribbon {

// A text file: what is being written (the job: its recording and settings), then a line for each
// file once that is complete, with its size and checksum. A kill loses at most the lines of frames
// in flight, which are then written again.
class SequenceLog {
 public:
  // Is there one, of whatever job?
  static bool is_at(const std::filesystem::path& path);
  // An older log under that name is replaced. `job` is one line or several.
  static Result<SequenceLog> begin(const std::filesystem::path& path, const std::string& job);
  // Goes on with the log that is there. Fails where it cannot be read, or is of another job.
  static Result<SequenceLog> resume(const std::filesystem::path& path, const std::string& job);

  // The size of the file of frame `number`, where that is complete and as it was written; 0
  // otherwise.
  [[nodiscard]] std::uint64_t complete_bytes(int number, const std::filesystem::path& file) const;

  // The file of frame `number` is complete and holds `bytes`. May be called from several threads.
  Result<void> add(int number, std::string_view bytes);

  // Forgets everything: the log is removed.
  void remove();
  // Has any frame been completed, now or before?
  [[nodiscard]] bool empty() const;

 private:
  struct Entry {
    std::uint64_t bytes = 0;
    std::uint32_t checksum = 0;
  };

  explicit SequenceLog(std::filesystem::path path) : path_(std::move(path)) {}
  Result<void> open();
  void read_entries(const std::string& text);

  std::filesystem::path path_;
  FileDescriptor file_;
  std::map<int, Entry> complete_;
  bool added_ = false;
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
};

}  // namespace ribbon
