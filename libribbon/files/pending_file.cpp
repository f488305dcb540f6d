#include "files/pending_file.h"

#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>

namespace ribbon {

namespace {

constexpr std::size_t worth_a_write = 1 << 16;

}  // namespace

Result<PendingFile> PendingFile::create(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::exists(path, code) && !std::filesystem::is_regular_file(path, code))
    return failure(path.string(), "is a folder, a device or a pipe, not a file",
                   "choose another name");
  auto part = PartFile::create(path);
  if (!part) return tl::unexpected(part.error());
  return PendingFile(path, *std::move(part));
}

Result<void> PendingFile::append(std::string_view bytes) {
  size_ += bytes.size();
  if (waiting_.size() + bytes.size() < worth_a_write) {
    waiting_ += bytes;
    return {};
  }
  if (auto written = write_waiting(); !written) return written;
  if (!write_all(part_.file(), bytes)) return cannot_be_written(path_);
  return {};
}

Result<void> PendingFile::write_waiting() {
  if (!write_all(part_.file(), waiting_)) return cannot_be_written(path_);
  waiting_.clear();
  return {};
}

Result<void> PendingFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  assert(offset + bytes.size() <= size_);
  if (auto written = write_waiting(); !written) return written;
  while (!bytes.empty()) {
    const ssize_t written =
        ::pwrite(part_.file().number(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return cannot_be_written(path_);
    offset += static_cast<std::uint64_t>(written);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

Result<void> PendingFile::finish(Older older) {
  if (auto written = write_waiting(); !written) return written;
  // Forced to the disk before the rename: a power cut must not leave an empty file under the name.
  if (::fsync(part_.file().number()) != 0) return cannot_be_written(path_);
  if (!part_.file().close()) return cannot_be_written(path_);
  return part_.take_place_of(path_, older);
}

}  // namespace ribbon
