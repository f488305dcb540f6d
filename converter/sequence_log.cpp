#include "converter/sequence_log.h"

#include <fcntl.h>

#include <sstream>
#include <utility>

#include "files/files.h"
#include "recording/coding/checksum.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr std::string_view separator = "complete (frame, bytes, CRC-32):\n";

std::string heading(const std::string& job) {
  return job + std::string(separator);
}

bool is_log(const std::string& text) {
  return text.find(separator) != std::string::npos;
}

}  // namespace

bool SequenceLog::is_at(const std::filesystem::path& path) {
  const auto text = read_file(path);
  return text && is_log(*text);
}

Result<SequenceLog> SequenceLog::begin(const std::filesystem::path& path, const std::string& job) {
  SequenceLog log(path);
  return write_file(path, heading(job)).and_then([&] { return log.open(); }).map([&] {
    return std::move(log);
  });
}

Result<SequenceLog> SequenceLog::resume(const std::filesystem::path& path, const std::string& job) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  if (!is_log(*text))
    return failure(path.string(), "is no log of a conversion that was stopped",
                   "name another file after -o");
  if (!text->starts_with(heading(job)))
    return failure(path.string(), "tells of another recording or other settings than are asked for",
                   "repeat the command line that was stopped, or begin anew with --force");
  SequenceLog log(path);
  log.read_entries(text->substr(heading(job).size()));
  return log.open().map([&] { return std::move(log); });
}

Result<void> SequenceLog::open() {
  file_ = FileDescriptor(::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (!file_.is_open())
    return failure(path_.string(), "cannot be written (" + last_error_text() + ")",
                   "choose a folder that you may write to");
  return {};
}

// A line that was cut short is either none or says nothing that is right by chance: its checksum is
// not the file's.
void SequenceLog::read_entries(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream values(line);
    int number = 0;
    Entry entry;
    if (values >> number >> entry.bytes >> entry.checksum) complete_[number] = entry;
  }
}

std::uint64_t SequenceLog::complete_bytes(int number, const std::filesystem::path& file) const {
  const auto found = complete_.find(number);
  if (found == complete_.end()) return 0;
  const auto bytes = read_file(file);
  const bool same =
      bytes && bytes->size() == found->second.bytes && checksum(*bytes) == found->second.checksum;
  return same ? bytes->size() : 0;
}

Result<void> SequenceLog::add(int number, std::string_view bytes) {
  const std::string line = filled_in("{} {} {}\n", number, bytes.size(), checksum(bytes));
  const std::lock_guard lock(*mutex_);
  added_ = true;
  if (!write_all(file_, line)) return cannot_be_written(path_);
  return {};
}

void SequenceLog::remove() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

bool SequenceLog::empty() const {
  return complete_.empty() && !added_;
}

}  // namespace ribbon
