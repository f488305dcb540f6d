#include "converter/output_names.h"

#include <filesystem>

namespace ribbon {

std::string material_library_name(const std::string& output) {
  std::string name = std::filesystem::path(output).stem().string();
  const std::size_t open = name.find('{');
  const std::size_t close = name.find('}', open == std::string::npos ? 0 : open);
  if (open != std::string::npos && close != std::string::npos) name.erase(open, close - open + 1);
  constexpr const char* separators = "._- ";
  name.erase(name.find_last_not_of(separators) + 1);
  name.erase(0, name.find_first_not_of(separators));
  return (name.empty() ? "ribbon" : name) + ".mtl";
}

}  // namespace ribbon
