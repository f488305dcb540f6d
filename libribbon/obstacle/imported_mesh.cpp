#include "obstacle/imported_mesh.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <bit>
#include <charconv>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ribbon {

namespace {

// Written out: Eigen's order depends on vector instructions.
Eigen::Vector4d product(const Eigen::Matrix4d& a, const Eigen::Vector4d& b) {
  return a.col(0) * b[0] + a.col(1) * b[1] + a.col(2) * b[2] + a.col(3) * b[3];
}

Eigen::Matrix4d product(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b) {
  Eigen::Matrix4d columns;
  for (Eigen::Index i = 0; i < 4; ++i) columns.col(i) = product(a, Eigen::Vector4d(b.col(i)));
  return columns;
}

Eigen::Matrix4d matrix_of(const aiMatrix4x4& matrix) {
  using Rows = Eigen::Matrix<ai_real, 4, 4, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(&matrix.a1).cast<double>();
}

// Which axis of an FBX file is meant by `name`; zero where it does not say so.
Eigen::RowVector3d axis_of(const aiMetadata& metadata, const std::string& name) {
  Eigen::RowVector3d row = Eigen::RowVector3d::Zero();
  std::int32_t axis = 0;
  std::int32_t sign = 0;
  if (metadata.Get(name + "Axis", axis) && metadata.Get(name + "AxisSign", sign) && axis >= 0 &&
      axis < 3)
    row[axis] = sign < 0 ? -1 : 1;
  return row;
}

// From what an FBX file says of itself.
Eigen::Matrix4d to_metres_and_y_up(const aiScene& file) {
  Eigen::Matrix4d turned = Eigen::Matrix4d::Identity();
  if (file.mMetaData == nullptr) return turned;
  Eigen::Matrix3d axes;
  axes << axis_of(*file.mMetaData, "Coord"), axis_of(*file.mMetaData, "Up"),
      axis_of(*file.mMetaData, "Front");
  if (axes.determinant() != 0) turned.topLeftCorner<3, 3>() = axes;
  float unit_cm = 0;
  if (file.mMetaData->Get("UnitScaleFactor", unit_cm) && unit_cm > 0)
    turned.topRows<3>() *= static_cast<double>(unit_cm) / 100;
  return turned;
}

struct PlacedNode {
  const aiNode* node;
  Eigen::Matrix4d place;  // from the node's coordinates to the world's
};

void collect(const aiNode& node, const Eigen::Matrix4d& parent, std::vector<PlacedNode>& nodes) {
  const Eigen::Matrix4d place = product(parent, matrix_of(node.mTransformation));
  nodes.push_back({&node, place});
  for (unsigned i = 0; i < node.mNumChildren; ++i) collect(*node.mChildren[i], place, nodes);
}

using Joints = std::map<std::string, Eigen::Matrix4d>;

Joints joints_of(const std::vector<PlacedNode>& nodes) {
  Joints joints;
  for (const PlacedNode& node : nodes) joints.emplace(node.node->mName.C_Str(), node.place);
  return joints;
}

bool holds_triangles(const aiMesh& mesh) {
  return (mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0;
}

bool names_only_its_vertices(const aiMesh& mesh) {
  const auto is_there = [&](unsigned vertex) { return vertex < mesh.mNumVertices; };
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (!std::all_of(face.mIndices, face.mIndices + face.mNumIndices, is_there)) return false;
  }
  for (unsigned b = 0; b < mesh.mNumBones; ++b) {
    const aiBone& bone = *mesh.mBones[b];
    if (!std::all_of(bone.mWeights, bone.mWeights + bone.mNumWeights,
                     [&](const aiVertexWeight& weight) { return is_there(weight.mVertexId); }))
      return false;
  }
  return true;
}

// From a mesh's coordinates to the world's, vertex by vertex.
class Places {
 public:
  Places(const aiMesh& mesh, Eigen::Matrix4d node, const Joints& joints) : node_(std::move(node)) {
    if (mesh.mNumBones > 0) by_joints_.assign(mesh.mNumVertices, Eigen::Matrix4d::Zero());
    for (unsigned b = 0; b < mesh.mNumBones; ++b) add(*mesh.mBones[b], joints);
  }

  // A sum of joints holds the sum of their weights in its last corner. What hangs on none goes with
  // the node.
  [[nodiscard]] const Eigen::Matrix4d& of(std::size_t vertex) const {
    return !by_joints_.empty() && by_joints_[vertex](3, 3) > 0 ? by_joints_[vertex] : node_;
  }

 private:
  void add(const aiBone& bone, const Joints& joints) {
    const auto joint = joints.find(bone.mName.C_Str());
    if (joint == joints.end()) return;
    const Eigen::Matrix4d moved = product(joint->second, matrix_of(bone.mOffsetMatrix));
    for (unsigned w = 0; w < bone.mNumWeights; ++w)
      by_joints_[bone.mWeights[w].mVertexId] +=
          static_cast<double>(bone.mWeights[w].mWeight) * moved;
  }

  Eigen::Matrix4d node_;
  std::vector<Eigen::Matrix4d> by_joints_;  // empty: the mesh has no joints
};

bool is_mirrored(const Eigen::Matrix4d& place) {
  return place.topLeftCorner<3, 3>().determinant() < 0;
}

// Triangles that share the vertices that are equal.
class JoinedTriangles {
 public:
  void add(const aiMesh& mesh, const Places& places) {
    std::vector<bool> used(mesh.mNumVertices);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f)
      for (unsigned c = 0; c < 3; ++c) used[mesh.mFaces[f].mIndices[c]] = true;
    std::vector<int> joined(mesh.mNumVertices);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      if (used[v]) joined[v] = joined_vertex(mesh.mVertices[v], places.of(v));
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const unsigned* corners = mesh.mFaces[f].mIndices;
      Eigen::Vector3i triangle(joined[corners[0]], joined[corners[1]], joined[corners[2]]);
      if (is_mirrored(places.of(corners[0]))) std::swap(triangle[1], triangle[2]);
      triangles_.push_back(triangle);
    }
  }

  [[nodiscard]] TriangleMesh mesh() const {
    TriangleMesh mesh;
    mesh.vertices.resize(3, static_cast<Eigen::Index>(vertices_.size()));
    mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles_.size()));
    for (std::size_t v = 0; v < vertices_.size(); ++v)
      mesh.vertices.col(static_cast<Eigen::Index>(v)) = vertices_[v];
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      mesh.triangles.col(static_cast<Eigen::Index>(t)) = triangles_[t];
    return mesh;
  }

 private:
  int joined_vertex(const aiVector3D& at, const Eigen::Matrix4d& place) {
    const Eigen::Vector4d from(at.x, at.y, at.z, 1);
    const Eigen::Vector3f vertex = product(place, from).hnormalized().cast<float>();
    // By their bits, since what is no number equals nothing.
    const std::array<std::uint32_t, 3> bits{std::bit_cast<std::uint32_t>(vertex.x()),
                                            std::bit_cast<std::uint32_t>(vertex.y()),
                                            std::bit_cast<std::uint32_t>(vertex.z())};
    const auto [known, is_new] = numbers_.emplace(bits, static_cast<int>(vertices_.size()));
    if (is_new) vertices_.push_back(vertex);
    return known->second;
  }

  std::map<std::array<std::uint32_t, 3>, int> numbers_;
  std::vector<Eigen::Vector3f> vertices_;
  std::vector<Eigen::Vector3i> triangles_;
};

// "ext%20file.bin" is "ext file.bin".
std::string percent_decoded(std::string name) {
  for (std::size_t at = name.find('%'); at != std::string::npos; at = name.find('%', at + 1)) {
    const char* const digits = name.data() + at + 1;
    std::uint8_t byte = 0;
    if (at + 2 < name.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2)
      name.replace(at, 3, 1, static_cast<char>(byte));
  }
  return name;
}

// A file and those that it refers to. glTF encodes their names by percent signs, which assimp 5.2
// takes for parts of the names.
class FilesOfMesh final : public Assimp::DefaultIOSystem {
 public:
  explicit FilesOfMesh(const std::filesystem::path& mesh) : folder_(mesh.parent_path().string()) {}

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    if (Assimp::IOStream* opened = DefaultIOSystem::Open(file, mode)) return opened;
    last_missing_ = file;
    const std::size_t own = last_missing_.starts_with(folder_) ? folder_.size() : 0;
    last_missing_.replace(own, std::string::npos, percent_decoded(last_missing_.substr(own)));
    return DefaultIOSystem::Open(last_missing_.c_str(), mode);
  }

  [[nodiscard]] const std::string& last_missing() const { return last_missing_; }

 private:
  std::string folder_;  // its name is nobody's code
  std::string last_missing_;
};

}  // namespace

std::optional<TriangleMesh> merged_mesh(const aiScene& file) {
  std::vector<PlacedNode> nodes;
  collect(*file.mRootNode, to_metres_and_y_up(file), nodes);
  const Joints joints = joints_of(nodes);
  JoinedTriangles result;
  for (const auto& [node, place] : nodes)
    for (unsigned m = 0; m < node->mNumMeshes; ++m) {
      const aiMesh& mesh = *file.mMeshes[node->mMeshes[m]];
      if (!holds_triangles(mesh)) continue;
      if (!names_only_its_vertices(mesh)) return std::nullopt;
      result.add(mesh, Places(mesh, place, joints));
    }
  return result.mesh();
}

ImportedMesh import_mesh(const std::filesystem::path& path) {
  Assimp::Importer importer;
  auto* const files = new FilesOfMesh(path);  // goes with the importer
  importer.SetIOHandler(files);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* file =
      importer.ReadFile(path.string(), aiProcess_Triangulate | aiProcess_SortByPType);
  if (file != nullptr) return {merged_mesh(*file), ""};
  // Materials of .obj, for example, may be missing.
  const std::string_view problem = importer.GetErrorString();
  const bool is_needed = problem.find("could not open referenced file") != std::string_view::npos;
  return {std::nullopt, is_needed ? files->last_missing() : ""};
}

bool is_importable(const std::string& extension) {
  return Assimp::Importer().IsExtensionSupported(extension);
}

}  // namespace ribbon
