#include "obstacle/obstacle.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "obstacle/isolated.h"

namespace ribbon {

namespace {

// Everything but positions and faces is dropped before equal vertices are joined: a seam in uv or
// normals must not tear the surface open.
constexpr unsigned dropped_components =
    aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
    aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
    aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS | aiComponent_MATERIALS;

constexpr unsigned steps = aiProcess_RemoveComponent | aiProcess_Triangulate |
                           aiProcess_PreTransformVertices | aiProcess_SortByPType |
                           aiProcess_JoinIdenticalVertices;

bool holds_triangles(const aiMesh& mesh) {
  return (mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0;
}

// All triangles of all meshes of the file, in its units.
TriangleMesh merged(const aiScene& file) {
  Eigen::Index vertex_count = 0;
  Eigen::Index triangle_count = 0;
  for (unsigned m = 0; m < file.mNumMeshes; ++m) {
    if (!holds_triangles(*file.mMeshes[m])) continue;
    vertex_count += file.mMeshes[m]->mNumVertices;
    triangle_count += file.mMeshes[m]->mNumFaces;
  }
  TriangleMesh result;
  result.vertices.resize(3, vertex_count);
  result.triangles.resize(3, triangle_count);
  int vertex = 0;
  int triangle = 0;
  for (unsigned m = 0; m < file.mNumMeshes; ++m) {
    const aiMesh& mesh = *file.mMeshes[m];
    if (!holds_triangles(mesh)) continue;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f)
      for (unsigned corner = 0; corner < 3; ++corner)
        result.triangles(corner, triangle + static_cast<int>(f)) =
            vertex + static_cast<int>(mesh.mFaces[f].mIndices[corner]);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      result.vertices.col(vertex + static_cast<int>(v)) << mesh.mVertices[v].x, mesh.mVertices[v].y,
          mesh.mVertices[v].z;
    vertex += static_cast<int>(mesh.mNumVertices);
    triangle += static_cast<int>(mesh.mNumFaces);
  }
  return result;
}

// As the other process hands it over: the number of vertices, their coordinates, the corners.
std::string bytes_of(const TriangleMesh& mesh) {
  const std::int64_t vertices = mesh.vertices.cols();
  std::string bytes(reinterpret_cast<const char*>(&vertices), sizeof(vertices));
  bytes.append(reinterpret_cast<const char*>(mesh.vertices.data()),
               sizeof(float) * mesh.vertices.size());
  bytes.append(reinterpret_cast<const char*>(mesh.triangles.data()),
               sizeof(int) * mesh.triangles.size());
  return bytes;
}

// Nothing where it is none: what made it may have been astray.
std::optional<TriangleMesh> mesh_of(std::string_view bytes) {
  std::int64_t vertices = 0;
  if (bytes.size() < sizeof(vertices)) return std::nullopt;
  std::memcpy(&vertices, bytes.data(), sizeof(vertices));
  bytes.remove_prefix(sizeof(vertices));
  constexpr std::size_t vertex_bytes = 3 * sizeof(float);
  constexpr std::size_t triangle_bytes = 3 * sizeof(int);
  if (vertices < 0 || static_cast<std::size_t>(vertices) > bytes.size() / vertex_bytes)
    return std::nullopt;
  TriangleMesh mesh;
  mesh.vertices.resize(3, vertices);
  const std::size_t of_vertices = vertex_bytes * static_cast<std::size_t>(vertices);
  std::copy_n(bytes.data(), of_vertices, reinterpret_cast<char*>(mesh.vertices.data()));
  bytes.remove_prefix(of_vertices);
  mesh.triangles.resize(3, static_cast<Eigen::Index>(bytes.size() / triangle_bytes));
  std::copy_n(bytes.data(), triangle_bytes * mesh.triangles.cols(),
              reinterpret_cast<char*>(mesh.triangles.data()));
  const auto corners = mesh.triangles.array();
  if (!((corners >= 0) && (corners < static_cast<int>(vertices))).all()) return std::nullopt;
  return mesh;
}

// Nothing, not even a count, where assimp cannot read it.
std::string imported(const std::filesystem::path& path) {
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, static_cast<int>(dropped_components));
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* file = importer.ReadFile(path.string(), steps);
  return file == nullptr ? std::string() : bytes_of(merged(*file));
}

// Damaged files make some of assimp's readers crash or run for ever.
std::optional<TriangleMesh> read_mesh(const std::filesystem::path& path) {
  constexpr std::uintmax_t least_s = 5;  // also for files beside it, as buffers of a .gltf
  constexpr std::uintmax_t bytes_a_second = 200'000;
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  const auto most_s = static_cast<unsigned>(least_s + (code ? 0 : size / bytes_a_second));
  const auto bytes = isolated([&] { return imported(path); }, most_s);
  return bytes ? mesh_of(*bytes) : std::nullopt;
}

std::optional<Eigen::Index> first_not_finite(const TriangleMesh& mesh) {
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (const int corner : mesh.triangles.col(t))
      if (!mesh.vertices.col(corner).allFinite()) return t;
  return std::nullopt;
}

// Of which assimp reads the first triangle of each.
bool holds_triangle_strips(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  if (!std::getline(file, line) || !line.starts_with("ply")) return false;
  while (std::getline(file, line) && !line.starts_with("end_header")) {
    std::istringstream words(line);
    std::string element;
    std::string name;
    std::uint64_t count = 0;
    if (words >> element >> name >> count && element == "element" && name == "tristrips" &&
        count > 0)
      return true;
  }
  return false;
}

// Why assimp could not read a file that is there. What it says itself is for programmers.
tl::unexpected<Error> not_read(const NamedFile& file) {
  const std::string ending = file.path.extension().string();
  if (!Assimp::Importer().IsExtensionSupported(ending))
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
  if (holds_triangle_strips(scene.file.path))
    return failure(scene.file, "holds triangle strips, which are not read",
                   "export the object with single triangles, for example as .obj");
  auto read = read_mesh(scene.file.path);
  if (!read) return not_read(scene.file);
  TriangleMesh mesh = *std::move(read);
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
