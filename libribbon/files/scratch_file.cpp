#include "files/scratch_file.h"

#include <unistd.h>

#include <cerrno>
#include <string>
#include <utility>

namespace ribbon {

namespace {

constexpr std::size_t piece_bytes = 1 << 16;

}  // namespace

Result<ScratchFile> ScratchFile::create(const std::filesystem::path& path) {
  auto part = PartFile::create(path);
  if (!part) return tl::unexpected(part.error());
  return ScratchFile(path, std::move(part->file()));  // open, though its name goes now
}

ScratchFile::ScratchFile(std::filesystem::path path, FileDescriptor file)
    : path_(std::move(path)), file_(std::move(file)) {}

Result<void> ScratchFile::append(std::string_view bytes) {
  if (!write_all(file_, bytes)) return cannot_be_written(path_);
  return {};
}

Result<void> ScratchFile::append_to(PendingFile& file) const {
  std::string piece(piece_bytes, '\0');
  for (off_t offset = 0;;) {
    const ssize_t read = ::pread(file_.number(), piece.data(), piece.size(), offset);
    if (read < 0 && errno == EINTR) continue;
    if (read < 0) return cannot_be_written(path_);
    if (read == 0) return {};
    offset += read;
    const std::string_view bytes(piece.data(), static_cast<std::size_t>(read));
    if (auto appended = file.append(bytes); !appended) return appended;
  }
}

}  // namespace ribbon
