// What waits on the disk for its place in a file that is written from front to back.
#pragma once

#include <filesystem>
#include <string_view>

#include "files/descriptor.h"
#include "files/pending_file.h"
#include "result/result.h"

namespace ribbon {

// Has no name, so that it is gone with the process, however that ends. Errors name the file that it
// is for.
class ScratchFile {
 public:
  // In the folder of `path`. Creates missing parent folders.
  static Result<ScratchFile> create(const std::filesystem::path& path);

  Result<void> append(std::string_view bytes);
  // Appends all of it to `file`.
  Result<void> append_to(PendingFile& file) const;

 private:
  ScratchFile(std::filesystem::path path, FileDescriptor file);

  std::filesystem::path path_;
  FileDescriptor file_;
};

}  // namespace ribbon
