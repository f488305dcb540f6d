#include "scene/scene_files.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "files/temporary_folder.h"

namespace ribbon {

std::string smallest_scene() {
  return "[curve]\n"
         "points = [[0, 0], [100, 50]]\n"
         "[ribbon]\n"
         "width = 0.05\n"
         "along = 400\n"
         "across = 8\n"
         "[time]\n"
         "duration = 4\n"
         "# the end\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

Result<Scene> read_text(const std::string& text) {
  const std::filesystem::path file = temporary_file("knot.toml");
  EXPECT_TRUE(write_file(file, text).has_value());
  return read_scene(file);
}

std::string complaint(const std::string& text) {
  const Result<Scene> scene = read_text(text);
  if (scene) return "";
  return replaced(scene.error().sentence(), temporary_file("").string(), "");
}

}  // namespace ribbon
