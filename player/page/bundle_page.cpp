// bundle_page PAGE DECODER NEW: puts everything that a page loads into it, so that it loads
// nothing.
// {{text NAME}} is a file beside PAGE, as it is; {{packed NAME}} one of the folder DECODER,
// compressed by gzip, as base64. Other places stay for ribbon-play.
#include <libdeflate.h>

#include <filesystem>
#include <memory>
#include <string>

#include "commandline/tool.h"
#include "files/files.h"
#include "player/page/base64.h"
#include "player/page/page_parts.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;

std::string gzip(const std::string& bytes) {
  constexpr int smallest = 12;
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(smallest), libdeflate_free_compressor);
  std::string packed(libdeflate_gzip_compress_bound(compressor.get(), bytes.size()), '\0');
  packed.resize(libdeflate_gzip_compress(compressor.get(), bytes.data(), bytes.size(),
                                         packed.data(), packed.size()));
  return packed;
}

Result<std::string> content(std::string_view place, const fs::path& texts,
                            const fs::path& decoder) {
  const std::size_t space = place.find(' ');
  if (space == std::string_view::npos) return "{{" + std::string(place) + "}}";
  const std::string_view name = place.substr(space + 1);
  if (place.substr(0, space) == "text") return read_file(texts / name);
  return read_file(decoder / name).map([](const std::string& bytes) {
    return base64(gzip(bytes));
  });
}

Result<ExitCode> bundle(const fs::path& page, const fs::path& decoder, const fs::path& target) {
  const auto outline = read_file(page);
  if (!outline) return tl::unexpected(outline.error());
  std::string whole;
  for (const PagePart& part : page_parts(*outline)) {
    if (!part.is_place) {
      whole += part.text;
      continue;
    }
    const auto filled = content(part.text, page.parent_path(), decoder);
    if (!filled) return tl::unexpected(filled.error());
    whole += *filled;
  }
  return write_file(target, whole).map([] { return ExitCode::done; });
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("bundle_page", [&]() -> ribbon::Result<ribbon::ExitCode> {
    if (argc != 4) return ribbon::failure("", "needs three names", "bundle_page PAGE DECODER NEW");
    return ribbon::bundle(argv[1], argv[2], argv[3]);
  });
}
