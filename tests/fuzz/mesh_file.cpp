// Whatever the bytes of an obstacle's file, it becomes triangles that can be used or is refused
// with a sentence, even where assimp, which reads it, crashes or hangs.
#include <unistd.h>

#include <filesystem>
#include <string>

#include "fuzz/memory_file.h"
#include "fuzz/must.h"
#include "obstacle/obstacle.h"

namespace ribbon {
namespace {

// A name for a file in memory, with the ending by which a reader is chosen.
class Link {
 public:
  Link(const MemoryFile& file, const std::string& ending)
      : path_(std::filesystem::temp_directory_path() /
              ("ribbon_fuzz_" + std::to_string(getpid()) + ending)) {
    std::filesystem::remove(path_);
    std::filesystem::create_symlink(file.path(), path_);
  }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  ~Link() { std::filesystem::remove(path_); }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// "ply", "solid" and "glTF" are what files of these kinds begin with.
std::string ending_for(char first) {
  switch (first) {
    case 'p':
      return ".ply";
    case 's':
      return ".stl";
    case 'g':
      return ".glb";
    default:
      return ".obj";
  }
}

void check(const TriangleMesh& mesh) {
  must(mesh.triangles.cols() > 0, "an obstacle has triangles");
  must(mesh.triangles.minCoeff() >= 0 && mesh.triangles.maxCoeff() < mesh.vertices.cols(),
       "triangles have vertices that are there");
  for (const int corner : mesh.triangles.reshaped())
    must(mesh.vertices.col(corner).allFinite(), "they are finite");
}

}  // namespace
}  // namespace ribbon

// libFuzzer gives the name. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ribbon;
  if (size == 0) return 0;
  const MemoryFile file("obstacle");
  file.append(data, size);
  const Link link(file, ending_for(static_cast<char>(data[0])));
  ObstacleScene scene;
  scene.file.path = link.path();
  if (const auto mesh = read_obstacle(scene)) check(*mesh);
  return 0;
}
