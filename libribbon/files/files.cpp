#include "files/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <system_error>

#include "files/descriptor.h"

namespace ribbon {

Result<std::string> read_file(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code))
    return failure(path.string(), "is a folder", "name a file");
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
  if (auto created = create_folder_of(path); !created) return created;
  const std::filesystem::path temporary = path.string() + ".part" + std::to_string(::getpid());
  FileDescriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!file.is_open())
    return failure(path.string(), "cannot be written (" + last_error_text() + ")",
                   "choose a folder that you may write to");
  // Forced to the disk before the rename: a power cut must not leave an empty file under the name.
  const bool written = write_all(file, bytes) && ::fsync(file.number()) == 0;
  std::string problem = written ? "" : last_error_text();
  if (!file.close() && problem.empty()) problem = last_error_text();
  if (problem.empty() && ::rename(temporary.c_str(), path.c_str()) != 0)
    problem = last_error_text();
  if (!problem.empty()) {
    ::unlink(temporary.c_str());
    return failure(path.string(), "cannot be written (" + problem + ")",
                   "free some space or choose another place");
  }
  return {};
}

Result<void> replace_file(const std::filesystem::path& path,
                          const std::filesystem::path& replacement) {
  if (::rename(replacement.c_str(), path.c_str()) != 0)
    return failure(path.string(), "cannot be replaced (" + last_error_text() + ")",
                   "check the permissions of its folder");
  sync_folder_of(path);
  return {};
}

}  // namespace ribbon
