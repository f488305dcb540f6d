#include "obstacle/obstacle.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <utility>

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

std::optional<Eigen::Index> first_not_finite(const TriangleMesh& mesh) {
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (const int corner : mesh.triangles.col(t))
      if (!mesh.vertices.col(corner).allFinite()) return t;
  return std::nullopt;
}

// Why assimp could not read a file that is there. What it says itself is for programmers.
tl::unexpected<Error> not_read(const NamedFile& file, const Assimp::Importer& importer) {
  const std::string ending = file.path.extension().string();
  if (!importer.IsExtensionSupported(ending))
    return failure(file, "is no kind of mesh file that can be read",
                   "export the object as .obj, .ply, .stl, .glb or .fbx");
  return failure(file,
                 "gives no triangles: it is damaged, of another kind than " + ending +
                     ", or holds nothing but points and lines",
                 "export the object again with its faces, for example as .obj");
}

}  // namespace

Result<TriangleMesh> read_obstacle(const ObstacleScene& scene) {
  if (auto there = check_readable(scene.file); !there) return tl::unexpected(there.error());
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, static_cast<int>(dropped_components));
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* file = importer.ReadFile(scene.file.path.string(), steps);
  if (file == nullptr) return not_read(scene.file, importer);
  TriangleMesh mesh = merged(*file);
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
