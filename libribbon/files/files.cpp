#include "files/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "files/descriptor.h"
#include "files/pending_file.h"

namespace ribbon {

namespace {

Result<void> write_once(const std::filesystem::path& path, std::string_view bytes, Older older) {
  auto file = PendingFile::create(path);
  if (!file) return tl::unexpected(file.error());
  return file->append(bytes).and_then([&] { return file->finish(older); });
}

}  // namespace

bool is_taken(const std::filesystem::path& path) {
  std::error_code code;
  const auto status = std::filesystem::symlink_status(path, code);
  return std::filesystem::exists(status) &&
         !std::filesystem::is_other(std::filesystem::status(path, code));
}

bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
  // Of a relative name whose first part is not there, weakly_canonical would leave it relative.
  const auto whole = [](const std::filesystem::path& path) {
    std::error_code code;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, code), code);
  };
  std::error_code code;
  return std::filesystem::equivalent(one, other, code) || whole(one) == whole(other);
}

Result<std::string> read_file(const std::filesystem::path& path, std::uintmax_t most_bytes) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code))
    return failure(path.string(), "is a folder", "name a file");
  if (std::filesystem::is_character_file(path, code))
    return failure(path.string(), "is a device, which may never end", "name a file");
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open())
    return failure(path.string(), "cannot be opened (" + last_error_text() + ")",
                   "check the name and the permissions");
  constexpr std::size_t part_bytes = 1 << 16;
  std::string bytes;
  while (bytes.size() <= most_bytes) {
    const std::size_t filled = bytes.size();
    bytes.resize(filled + part_bytes);
    const ssize_t got = ::read(file.number(), bytes.data() + filled, part_bytes);
    if (got < 0 && errno != EINTR)
      return failure(path.string(), "cannot be read (" + last_error_text() + ")", "check the disk");
    bytes.resize(filled + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0) return bytes;
  }
  return failure(path.string(),
                 "is larger than the " + std::to_string(most_bytes / 1'000'000) +
                     " MB that such a file may have",
                 "check that it is the one that is meant");
}

Result<void> write_file(const std::filesystem::path& path, std::string_view bytes, Older older) {
  auto written = write_once(path, bytes, older);
  // Another process may have taken the temporary file for what a kill has left.
  if (!written && written.error().may_pass) written = write_once(path, bytes, older);
  return written;
}

}  // namespace ribbon
