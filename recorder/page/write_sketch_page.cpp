#include "recorder/page/write_sketch_page.h"

#include "files/files.h"
#include "page/page_parts.h"
#include "recorder/page/packed.h"
#include "recorder/page/scene_json.h"
#include "recorder/page/sketch_page.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

Result<std::string> packed_scene(const std::optional<Scene>& scene) {
  if (!scene) return "";
  return scene_json(*scene).map([](const Json& json) { return packed(json.line()); });
}

}  // namespace

Result<std::string> write_sketch_page(const std::optional<Scene>& scene,
                                      const std::filesystem::path& page, Older older) {
  if (sketch_page().empty())
    return failure(page.string(),
                   "cannot be written: this ribbon-record was built without Emscripten",
                   "install it by 'source .ci/setup.sh && install_page_tools', and build again "
                   "(docs/page.md)");
  if (older == Older::stays && is_taken(page))
    return failure(page.string(), "exists already", "name another file, or replace it by --force");
  const auto filled = packed_scene(scene);
  if (!filled) return tl::unexpected(filled.error());
  std::string whole;
  bool is_left_out = false;
  for (const PagePart& part : page_parts(sketch_page())) {
    if (part.is_place) is_left_out = scene && part.text == "offered";
    if (part.is_place && part.text == "scene")
      whole += *filled;
    else if (!part.is_place && !is_left_out)
      whole += part.text;
  }
  const double megabytes = static_cast<double>(whole.size()) / 1e6;
  return write_file(page, whole, older).map([&] {
    return filled_in("page: {} ({:.1f} MB); open it in a browser\n", page.string(), megabytes);
  });
}

}  // namespace ribbon
