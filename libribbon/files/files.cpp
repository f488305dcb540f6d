#include "files/files.h"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <system_error>

#include "files/descriptor.h"
#include "files/pending_file.h"

namespace ribbon {

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

Result<std::string> read_file(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code))
    return failure(path.string(), "is a folder", "name a file");
  if (std::filesystem::is_character_file(path, code))
    return failure(path.string(), "is a device, which may never end", "name a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    return failure(path.string(), "cannot be opened (" + last_error_text() + ")",
                   "check the name and the permissions");
  std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (stream.bad())
    return failure(path.string(), "cannot be read (" + last_error_text() + ")", "check the disk");
  return bytes;
}

Result<void> write_file(const std::filesystem::path& path, std::string_view bytes) {
  auto file = PendingFile::create(path);
  if (!file) return tl::unexpected(file.error());
  return file->append(bytes).and_then([&] { return file->finish(); });
}

}  // namespace ribbon
