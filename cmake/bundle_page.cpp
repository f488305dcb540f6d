// bundle_page PAGE NEW FOLDER...: puts everything that a page loads into it, so that it loads
// nothing.
// {{text NAME}} is a file of the first of the folders that has it, as it is; {{packed NAME}}
// likewise, as packed(). Other places stay for the tool that writes the page.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "commandline/tool.h"
#include "files/files.h"
#include "page/page_parts.h"
#include "recorder/page/packed.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;

using Folders = std::vector<fs::path>;

Result<std::string> file_of(const Folders& folders, std::string_view name) {
  const auto folder = std::find_if(folders.begin(), folders.end(),
                                   [&](const fs::path& one) { return fs::exists(one / name); });
  if (folder != folders.end()) return read_file(*folder / name);
  return failure(std::string(name), "lies in none of the folders", "name its folder, too");
}

Result<std::string> content(std::string_view place, const Folders& folders) {
  const std::size_t space = place.find(' ');
  if (space == std::string_view::npos) return "{{" + std::string(place) + "}}";
  auto file = file_of(folders, place.substr(space + 1));
  if (place.substr(0, space) == "text") return file;
  return file.map(packed);
}

Result<ExitCode> bundle(const fs::path& page, const fs::path& target, const Folders& folders) {
  const auto outline = read_file(page);
  if (!outline) return tl::unexpected(outline.error());
  std::string whole;
  for (const PagePart& part : page_parts(*outline)) {
    if (!part.is_place) {
      whole += part.text;
      continue;
    }
    const auto filled = content(part.text, folders);
    if (!filled) return tl::unexpected(filled.error());
    whole += *filled;
  }
  return write_file(target, whole).map([] { return ExitCode::done; });
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("bundle_page", [&]() -> ribbon::Result<ribbon::ExitCode> {
    if (argc < 4)
      return ribbon::failure("", "needs at least three names", "bundle_page PAGE NEW FOLDER...");
    return ribbon::bundle(argv[1], argv[2], {argv + 3, argv + argc});
  });
}
