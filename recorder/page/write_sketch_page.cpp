#include "recorder/page/write_sketch_page.h"

#include <system_error>

#include "files/files.h"
#include "page/page_parts.h"
#include "recorder/page/scene_json.h"
#include "recorder/page/sketch_page.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// That a name in a scene ends the page's script is not to be.
std::string in_script(std::string json) {
  for (std::size_t i = 0; (i = json.find('<', i)) != std::string::npos;)
    json.replace(i, 1, "\\u003c");
  return json;
}

Result<std::string> json_of(const std::optional<Scene>& scene) {
  if (!scene) return "";
  return scene_json(*scene).map([](const Json& json) { return in_script(json.line()); });
}

}  // namespace

Result<std::string> write_sketch_page(const std::optional<Scene>& scene,
                                      const std::filesystem::path& page, Overwrite overwrite) {
  if (sketch_page().empty())
    return failure(page.string(),
                   "cannot be written: this ribbon-record was built without Emscripten",
                   "install it (apt-get install emscripten) and build again, as docs/page.md says");
  std::error_code code;
  if (overwrite == Overwrite::no && std::filesystem::exists(page, code))
    return failure(page.string(), "exists already", "name another file, or replace it by --force");
  const auto json = json_of(scene);
  if (!json) return tl::unexpected(json.error());
  std::string whole;
  for (const PagePart& part : page_parts(sketch_page())) whole += part.is_place ? *json : part.text;
  const double megabytes = static_cast<double>(whole.size()) / 1e6;
  return write_file(page, whole).map([&] {
    return filled_in("page: {} ({:.1f} MB); open it in a browser\n", page.string(), megabytes);
  });
}

}  // namespace ribbon
