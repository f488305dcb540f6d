#include "files/descriptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace ribbon {

bool FileDescriptor::close() {
  return !is_open() || ::close(std::exchange(number_, -1)) == 0;
}

bool write_all(const FileDescriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(written);
  }
  return true;
}

std::string last_error_text() {
  return std::error_code(errno, std::generic_category()).message();
}

tl::unexpected<Error> cannot_be_written(const std::filesystem::path& path) {
  const bool no_room = errno == ENOSPC || errno == EDQUOT;
  return tl::unexpected<Error>(
      Error{path.string(), "cannot be written (" + last_error_text() + ")",
            no_room ? "free some space or choose another place" : "choose another place", no_room});
}

std::filesystem::path linked_file(const std::filesystem::path& path) {
  std::error_code code;
  if (!std::filesystem::is_symlink(path, code)) return path;
  auto file = std::filesystem::canonical(path, code);
  return code ? path : file;
}

Result<void> create_folder_of(const std::filesystem::path& path) {
  const std::filesystem::path name = path.filename();
  if (name.empty() || name == "." || name == "..")
    return failure(path.string(), "is the name of a folder, not of a file", "name a file in it");
  std::error_code code;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), code);
  if (!code) return {};
  return failure(path.parent_path().string(), "cannot be created (" + code.message() + ")",
                 "choose a folder that you may write to");
}

void sync_folder_of(const std::filesystem::path& path) {
  const std::filesystem::path file = linked_file(path);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.is_open()) ::fsync(opened.number());
}

}  // namespace ribbon
