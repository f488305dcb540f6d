#include "player/output/manifest.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "files/files.h"
#include "recording/coding/checksum.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view made_of_mark = "made of ";
constexpr std::string_view interpolated_mark = ", interpolated";
constexpr std::string_view ending = ".txt";

// "frames/manifest.png" of all shards of 'frames/{frame}.png'.
fs::path common_name(const FramePattern& pattern) {
  return pattern.file(std::string("manifest"));
}

fs::path name_of(const FramePattern& pattern, const Shard& shard) {
  fs::path name = common_name(pattern);
  if (shard.parts > 1) name += filled_in(".{}of{}", shard.part, shard.parts);
  return name += ending;
}

std::string picture_line(const std::string& digits, double frame, std::uint64_t bytes,
                         std::uint32_t checksum) {
  return filled_in("picture {} of frame {:.12g}{}: {} bytes, checksum {}\n", digits, frame,
                   frame == std::floor(frame) ? "" : interpolated_mark, bytes,
                   hexadecimal(checksum));
}

// Takes `words` and what comes before the next space off the beginning of a line.
std::optional<std::string_view> word_taken(std::string_view& line, std::string_view words) {
  if (!line.starts_with(words)) return std::nullopt;
  line.remove_prefix(words.size());
  const std::string_view word = line.substr(0, line.find(' '));
  line.remove_prefix(word.size());
  return word;
}

// Takes `words` and then a number off the beginning of a line.
template <class Number, class... Base>
std::optional<Number> taken(std::string_view& line, std::string_view words, Base... base) {
  if (!line.starts_with(words)) return std::nullopt;
  Number number = 0;
  const char* begin = line.data() + words.size();
  const auto [stop, problem] = std::from_chars(begin, line.data() + line.size(), number, base...);
  if (problem != std::errc()) return std::nullopt;
  line.remove_prefix(static_cast<std::size_t>(stop - line.data()));
  return number;
}

}  // namespace

Manifest::Manifest(FramePattern pattern, MadeOf made_of)
    : pattern_(std::move(pattern)), made_of_(std::move(made_of)) {}

Result<Manifest> Manifest::open(const FramePattern& pattern, const MadeOf& made_of,
                                const Shard& shard) {
  Manifest manifest(pattern, made_of);
  manifest.path_ = name_of(pattern, shard);
  const fs::path common = common_name(pattern);
  const fs::path folder = common.has_parent_path() ? common.parent_path() : ".";
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename();
    if (name.starts_with(common.filename().string() + ".") && name.ends_with(ending))
      manifest.read(read_file(entry.path()).value_or(""));
  }
  manifest.file_ = FileDescriptor(::open(manifest.path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (!manifest.file_.is_open() && errno != ENOENT) return cannot_be_written(manifest.path_);
  return manifest;
}

void Manifest::read(std::string_view text) {
  bool is_current = false;
  // What has no line end was cut off.
  for (std::size_t end = 0; (end = text.find('\n')) != std::string_view::npos;
       text.remove_prefix(end + 1)) {
    const std::string_view line = text.substr(0, end);
    if (line.starts_with(made_of_mark))
      is_current = line.substr(made_of_mark.size()) == made_of_;
    else
      read_picture(line, is_current);
  }
}

void Manifest::read_picture(std::string_view line, bool is_current) {
  const auto digits = word_taken(line, "picture ");
  const auto frame = taken<double>(line, " of frame ");
  if (line.starts_with(interpolated_mark)) line.remove_prefix(interpolated_mark.size());
  const auto bytes = taken<std::uint64_t>(line, ": ");
  const auto checksum = taken<std::uint32_t>(line, " bytes, checksum ", 16);
  if (!digits || !frame || !bytes || !checksum || !line.empty()) return;
  Entry& entry = pictures_[std::string(*digits)];
  if (is_current || !entry.is_current) entry = {*frame, *bytes, *checksum, is_current};
}

bool Manifest::is_complete(int number, double frame) const {
  const auto entry = pictures_.find(pattern_.digits_of(number));
  if (entry == pictures_.end()) return false;
  const Entry& noted = entry->second;
  std::error_code code;
  const fs::path picture = pattern_.file(number);
  if (!noted.is_current || std::abs(noted.frame - frame) > same_moment ||
      fs::file_size(picture, code) != noted.bytes)
    return false;
  const auto bytes = read_file(picture);
  return bytes && checksum(*bytes) == noted.checksum;
}

Result<void> Manifest::begin() {
  if (std::exchange(is_begun_, true)) return {};
  if (!file_.is_open()) {
    if (auto created = create_folder_of(path_); !created) return created;
    file_ = FileDescriptor(::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    if (!file_.is_open()) return cannot_be_written(path_);
  }
  // A line that a kill has cut off ends here, and is none.
  std::error_code code;
  const bool is_new = fs::file_size(path_, code) == 0;
  return append((is_new ? "" : "\n") + std::string(made_of_mark) + made_of_ + "\n");
}

Result<void> Manifest::note(int number, double frame, std::string_view bytes) {
  if (auto begun = begin(); !begun) return begun;
  return append(picture_line(pattern_.digits_of(number), frame, bytes.size(), checksum(bytes)));
}

Result<void> Manifest::append(const std::string& line) {
  if (!write_all(file_, line) || ::fdatasync(file_.number()) != 0) return cannot_be_written(path_);
  return {};
}

}  // namespace ribbon
