// A file of any kind that assimp reads, as one mesh.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/triangle_mesh.h"

struct aiScene;

namespace ribbon {

// ".obj", in any case.
bool is_importable(const std::string& extension);

struct ImportedMesh {
  std::optional<TriangleMesh> mesh;  // nothing where assimp cannot read it
  std::string missing_file;          // that it refers to, if that is why
};

// It may as well crash, or never return.
ImportedMesh import_mesh(const std::filesystem::path& path);

// All triangles of the file, where its nodes and joints put them, counter-clockwise also where a
// node mirrors them. Vertices at equal positions are joined: a seam in uv or normals must not tear
// the surface open. An FBX file says what its unit and axes are, and is turned to metres and y up;
// all other formats are in the units that assimp gives. Polygons are cut into triangles before, and
// points and lines removed. Nothing where the file speaks of vertices that it does not hold.
std::optional<TriangleMesh> merged_mesh(const aiScene& file);

}  // namespace ribbon
