#include "scene/named_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

namespace ribbon {

Result<void> check_readable(const NamedFile& file) {
  std::error_code code;
  const auto status = std::filesystem::status(file.path, code);
  if (status.type() == std::filesystem::file_type::not_found)
    return failure(file, "does not exist",
                   "correct the name; what does not begin with '/' is looked for in the scene's "
                   "folder");
  if (std::filesystem::is_directory(status)) return failure(file, "is a folder", "name a file");
  if (std::filesystem::is_other(status))
    return failure(file, "is a device or a pipe, which may never end", "name a file");
  if (!std::ifstream(file.path))
    return failure(file, "cannot be opened (" + std::generic_category().message(errno) + ")",
                   "check its permissions");
  return {};
}

tl::unexpected<Error> failure(const NamedFile& file, const std::string& problem,
                              const std::string& remedy) {
  const std::string name = file.path.string();
  return file.place.empty() ? failure(name, problem, remedy)
                            : failure(file.place, "'" + name + "' " + problem, remedy);
}

}  // namespace ribbon
