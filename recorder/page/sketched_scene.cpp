#include "recorder/page/sketched_scene.h"

#include "scene/setting.h"

namespace ribbon {

Result<std::string> sketched_scene(const std::string& file, const std::string& text,
                                   const std::string& letters,
                                   const std::vector<std::string>& settings) {
  Result<std::string> changed = text;
  for (const char* key : {"points", "path", "first", "crossings"})
    changed = changed.and_then([&](const std::string& before) {
      return with_entry_replaced(file, before, "curve", key, "");
    });
  std::vector<std::string> all = {"curve.svg=\"" + std::string(sketched_drawing) + "\""};
  if (!letters.empty()) all.push_back("curve.crossings=\"" + letters + "\"");
  all.insert(all.end(), settings.begin(), settings.end());
  for (const std::string& setting : all)
    changed = changed.and_then(
        [&](const std::string& before) { return with_setting(file, before, setting); });
  return changed;
}

}  // namespace ribbon
