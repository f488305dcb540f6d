#include "player/page/write_page.h"

#include <algorithm>
#include <cstdint>

#include "files/pending_file.h"
#include "page/base64.h"
#include "page/page_parts.h"
#include "playback/random_access_file.h"
#include "player/page/viewer_page.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// As text and in attributes.
std::string escaped(std::string_view text) {
  std::string page;
  for (const char letter : text) switch (letter) {
      case '&':
        page += "&amp;";
        break;
      case '<':
        page += "&lt;";
        break;
      case '"':
        page += "&quot;";
        break;
      default:
        page += letter;
    }
  return page;
}

// Piece by piece, so that memory does not grow with the recording.
Result<void> append_base64(const RandomAccessFile& recording, const std::string& name,
                           const Stopped& stopped, PendingFile& page) {
  constexpr std::uint64_t piece = 3 << 16;
  for (std::uint64_t done = 0; done < recording.size(); done += piece) {
    if (stopped())
      return passing_failure(name, filled_in("interrupted at byte {} of it", done), "run it again");
    const std::string bytes = recording.read(done, piece);
    if (bytes.size() != std::min(piece, recording.size() - done))
      return failure(name, filled_in("cannot be read beyond byte {}", done + bytes.size()),
                     "check the disk, and copy the file");
    if (auto appended = page.append(base64(bytes)); !appended) return appended;
  }
  return {};
}

Result<void> append_place(std::string_view place, const RecordingReader& reader,
                          const std::filesystem::path& recording, const RandomAccessFile& bytes,
                          const Stopped& stopped, PendingFile& page) {
  if (place == "title") return page.append(escaped(reader.header().scene_name));
  if (place == "file") return page.append(escaped(recording.filename().string()));
  return append_base64(bytes, recording.string(), stopped, page);
}

}  // namespace

Result<std::string> write_page(const RecordingReader& reader,
                               const std::filesystem::path& recording,
                               const std::filesystem::path& page, Older older,
                               const Stopped& stopped) {
  if (viewer_page().empty())
    return failure(page.string(),
                   "cannot be written: this ribbon-play was built without Emscripten",
                   "install it by 'source .ci/setup.sh && install_page_tools', and build again "
                   "(docs/page.md)");
  const auto bytes = RandomAccessFile::open(recording);
  if (!bytes) return tl::unexpected(bytes.error());
  auto file = PendingFile::create(page);
  if (!file) return tl::unexpected(file.error());
  for (const PagePart& part : page_parts(viewer_page())) {
    const auto appended = part.is_place
                              ? append_place(part.text, reader, recording, *bytes, stopped, *file)
                              : file->append(part.text);
    if (!appended) return tl::unexpected(appended.error());
  }
  const double megabytes = static_cast<double>(file->size()) / 1e6;
  return file->finish(older).map(
      [&] { return filled_in("page: {} ({:.1f} MB)", page.string(), megabytes); });
}

}  // namespace ribbon
