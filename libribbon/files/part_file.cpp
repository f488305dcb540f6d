#include "files/part_file.h"

#include <unistd.h>

#include <string>
#include <system_error>

namespace ribbon {

PartFile::PartFile(const std::filesystem::path& whole)
    : path_(whole.string() + ".part" + std::to_string(::getpid())) {}

PartFile::~PartFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace ribbon
