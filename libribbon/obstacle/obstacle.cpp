#include "obstacle/obstacle.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "obstacle/imported_mesh.h"
#include "obstacle/isolated.h"

namespace ribbon {

namespace {

constexpr std::int64_t no_mesh = -1;

// As the other process hands it over: the number of vertices, their coordinates, the corners; or
// that there is no mesh, and which file is missing.
std::string bytes_of(const ImportedMesh& imported) {
  const std::int64_t vertices = imported.mesh ? imported.mesh->vertices.cols() : no_mesh;
  std::string bytes(reinterpret_cast<const char*>(&vertices), sizeof(vertices));
  if (!imported.mesh) return bytes + imported.missing_file;
  const TriangleMesh& mesh = *imported.mesh;
  bytes.append(reinterpret_cast<const char*>(mesh.vertices.data()),
               sizeof(float) * mesh.vertices.size());
  bytes.append(reinterpret_cast<const char*>(mesh.triangles.data()),
               sizeof(int) * mesh.triangles.size());
  return bytes;
}

// Without a mesh where it is none: what made it may have been astray.
ImportedMesh mesh_of(std::string_view bytes) {
  std::int64_t vertices = 0;
  if (bytes.size() < sizeof(vertices)) return {};
  std::memcpy(&vertices, bytes.data(), sizeof(vertices));
  bytes.remove_prefix(sizeof(vertices));
  if (vertices == no_mesh) return {std::nullopt, std::string(bytes)};
  constexpr std::size_t vertex_bytes = 3 * sizeof(float);
  constexpr std::size_t triangle_bytes = 3 * sizeof(int);
  if (vertices < 0 || static_cast<std::size_t>(vertices) > bytes.size() / vertex_bytes) return {};
  TriangleMesh mesh;
  mesh.vertices.resize(3, vertices);
  const std::size_t of_vertices = vertex_bytes * static_cast<std::size_t>(vertices);
  std::copy_n(bytes.data(), of_vertices, reinterpret_cast<char*>(mesh.vertices.data()));
  bytes.remove_prefix(of_vertices);
  mesh.triangles.resize(3, static_cast<Eigen::Index>(bytes.size() / triangle_bytes));
  std::copy_n(bytes.data(), triangle_bytes * mesh.triangles.cols(),
              reinterpret_cast<char*>(mesh.triangles.data()));
  const auto corners = mesh.triangles.array();
  if (!((corners >= 0) && (corners < static_cast<int>(vertices))).all()) return {};
  return {std::move(mesh), ""};
}

// Damaged files make some of assimp's readers crash or run for ever.
ImportedMesh read_mesh(const std::filesystem::path& path) {
  constexpr std::uintmax_t least_s = 5;  // also for files beside it, as buffers of a .gltf
  constexpr std::uintmax_t bytes_a_second = 200'000;
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  const auto most_s = static_cast<unsigned>(least_s + (code ? 0 : size / bytes_a_second));
  const auto bytes = isolated([&] { return bytes_of(import_mesh(path)); }, most_s);
  return bytes ? mesh_of(*bytes) : ImportedMesh{};
}

std::optional<Eigen::Index> first_not_finite(const TriangleMesh& mesh) {
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (const int corner : mesh.triangles.col(t))
      if (!mesh.vertices.col(corner).allFinite()) return t;
  return std::nullopt;
}

// Where the data of a PLY begin: behind the line that ends its header, however lines end.
std::optional<std::size_t> begin_of_data(const std::string& ply) {
  constexpr std::string_view last_line = "end_header";
  constexpr std::string_view line_ends = "\r\n";
  for (std::size_t at = ply.find(last_line); at != std::string::npos;
       at = ply.find(last_line, at + 1)) {
    const bool begins_a_line = at > 0 && line_ends.find(ply[at - 1]) != std::string_view::npos;
    const std::size_t end = ply.find_first_not_of(" \t", at + last_line.size());
    if (begins_a_line && end != std::string::npos &&
        line_ends.find(ply[end]) != std::string_view::npos)
      return end + (ply.compare(end, 2, line_ends) == 0 ? 2 : 1);
  }
  return std::nullopt;
}

// PLY that assimp 5.2 reads wrongly: of triangle strips it takes the first triangle of each, of
// data that begin with the byte of a line end it skips that, and it looks for ever for the end of a
// header that was cut off.
Result<void> check_ply(const NamedFile& file) {
  constexpr std::size_t longest_header = 1 << 16;
  std::string head(longest_header, '\0');
  std::ifstream opened(file.path, std::ios::binary);
  opened.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(opened.gcount()));
  if (!head.starts_with("ply")) return {};
  const auto data = begin_of_data(head);
  if (!data && head.size() < longest_header)
    return failure(file, "is cut off: its header has no end", "export the object again");
  std::istringstream lines(head.substr(0, data.value_or(head.size())));
  std::string line;
  bool is_binary = false;
  while (std::getline(lines, line)) {
    is_binary |= line.starts_with("format binary");
    std::istringstream words(line);
    std::string element;
    std::string name;
    std::uint64_t count = 0;
    if (words >> element >> name >> count && element == "element" && name == "tristrips" &&
        count > 0)
      return failure(file, "holds triangle strips, which are not read",
                     "export the object with single triangles, for example as .obj");
  }
  if (is_binary && data && head[*data] == '\n')
    return failure(
        file,
        "holds binary data that happen to begin with the byte of a line end, which are not "
        "read",
        "export the object as a .ply of text, or as .obj");
  return {};
}

// Why assimp could not read a file that is there. What it says itself is for programmers.
tl::unexpected<Error> not_read(const NamedFile& file, const std::string& missing_file) {
  if (!missing_file.empty())
    return failure(file, "needs '" + missing_file + "', which cannot be opened",
                   "put that there, or export the object as .glb, which holds all");
  const std::string ending = file.path.extension().string();
  if (!is_importable(ending))
    return failure(file, "is no kind of mesh file that can be read",
                   "export the object as .obj, .ply, .stl, .glb or .fbx");
  return failure(
      file,
      "gives no triangles: it is damaged, of another kind than " + ending +
          ", holds nothing but points and lines, or is written in a way that is not read",
      "export the object again with its faces, for example as .obj");
}

}  // namespace

Result<TriangleMesh> read_obstacle(const ObstacleScene& scene) {
  if (auto there = check_readable(scene.file); !there) return tl::unexpected(there.error());
  if (auto ply = check_ply(scene.file); !ply) return tl::unexpected(ply.error());
  auto read = read_mesh(scene.file.path);
  if (!read.mesh) return not_read(scene.file, read.missing_file);
  TriangleMesh mesh = *std::move(read.mesh);
  mesh.name = scene.file.path.stem().string();
  if (mesh.triangles.cols() == 0)
    return failure(scene.file, "gives no triangles", "export the object with its faces");
  mesh.vertices =
      ((mesh.vertices.cast<double>() * scene.scale).colwise() + scene.position_m).cast<float>();
  if (const auto triangle = first_not_finite(mesh))
    return failure(scene.file,
                   "has a coordinate in triangle " + std::to_string(*triangle + 1) + " of " +
                       std::to_string(mesh.triangles.cols()) + " that is not a finite number",
                   "repair the mesh or choose a smaller obstacle.scale");
  return mesh;
}

Result<std::optional<TriangleMesh>> read_obstacle(const Scene& scene) {
  if (!scene.obstacle) return std::nullopt;
  return read_obstacle(*scene.obstacle).map([](TriangleMesh mesh) {
    return std::optional(std::move(mesh));
  });
}

}  // namespace ribbon
