#include "converter/export/fbx_export.h"

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/metadata.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <cstdint>
#include <memory>

#include "converter/export/fbx_container.h"

namespace ribbon {

namespace {

// assimp's scenes own their arrays, whose elements must come from new[].
template <class Element>
Element* new_array(Eigen::Index count) {
  return new Element[static_cast<std::size_t>(count)]();
}

aiVector3D vector3(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

aiFace face_of(const Eigen::VectorXi& corners) {
  aiFace face;
  face.mNumIndices = static_cast<unsigned>(corners.size());
  face.mIndices = new_array<unsigned>(corners.size());
  std::copy(corners.begin(), corners.end(), face.mIndices);
  return face;
}

std::unique_ptr<aiMesh> mesh_of(const ModelObject& object, unsigned material) {
  auto mesh = std::make_unique<aiMesh>();
  const Eigen::Index vertices = object.positions.cols();
  mesh->mName.Set(object.name);
  mesh->mMaterialIndex = material;
  mesh->mPrimitiveTypes =
      object.faces.rows() == 3 ? aiPrimitiveType_TRIANGLE : aiPrimitiveType_POLYGON;
  mesh->mNumVertices = static_cast<unsigned>(vertices);
  mesh->mVertices = new_array<aiVector3D>(vertices);
  for (Eigen::Index i = 0; i < vertices; ++i) mesh->mVertices[i] = vector3(object.positions.col(i));
  if (object.uv.cols() > 0) {
    mesh->mNumUVComponents[0] = 2;
    mesh->mTextureCoords[0] = new_array<aiVector3D>(vertices);
    for (Eigen::Index i = 0; i < vertices; ++i)
      mesh->mTextureCoords[0][i] = {object.uv(0, i), object.uv(1, i), 0.0F};
  }
  mesh->mNumFaces = static_cast<unsigned>(object.faces.cols());
  mesh->mFaces = new_array<aiFace>(object.faces.cols());
  for (Eigen::Index i = 0; i < object.faces.cols(); ++i)
    mesh->mFaces[i] = face_of(object.faces.col(i));
  return mesh;
}

std::unique_ptr<aiMaterial> material_of(const Material& material) {
  auto result = std::make_unique<aiMaterial>();
  const aiString name(material.name);
  const aiColor3D color(material.color.x(), material.color.y(), material.color.z());
  result->AddProperty(&name, AI_MATKEY_NAME);
  result->AddProperty(&color, 1, AI_MATKEY_COLOR_DIFFUSE);
  return result;
}

std::unique_ptr<aiNode> node_of(const ModelObject& object, unsigned mesh) {
  auto node = std::make_unique<aiNode>(object.name);
  node->mNumMeshes = 1;
  node->mMeshes = new_array<unsigned>(1);
  node->mMeshes[0] = mesh;
  return node;
}

// FBX axes: 0 x, 1 y, 2 z. Its unit is the centimetre, so metres are a factor of 100; without these
// keys readers take one unit for 1 cm. assimp passes a key on only if its type is exact.
aiMetadata* metadata_of(const Model& model) {
  const bool z_up = model.placement.up == UpAxis::z;
  const double unit_cm = 100 * model.placement.metres_per_unit;
  auto metadata = std::make_unique<aiMetadata>();
  for (const auto& [key, value] : {std::pair<const char*, std::int32_t>{"UpAxis", z_up ? 2 : 1},
                                   {"UpAxisSign", 1},
                                   {"FrontAxis", z_up ? 1 : 2},
                                   {"FrontAxisSign", z_up ? -1 : 1},
                                   {"CoordAxis", 0},
                                   {"CoordAxisSign", 1},
                                   {"TimeMode", 14}})  // 14: custom frame rate
    metadata->Add(key, value);
  metadata->Add("UnitScaleFactor", unit_cm);
  metadata->Add("OriginalUnitScaleFactor", unit_cm);
  metadata->Add("CustomFrameRate", model.frames_per_second);
  return metadata.release();
}

std::unique_ptr<aiScene> scene_of(const Model& model) {
  auto scene = std::make_unique<aiScene>();
  const auto count = static_cast<Eigen::Index>(model.objects.size());
  // Vertices are shared by faces: without the flag assimp may split them.
  scene->mFlags |= AI_SCENE_FLAGS_NON_VERBOSE_FORMAT;
  scene->mMetaData = metadata_of(model);
  scene->mMeshes = new_array<aiMesh*>(count);
  scene->mMaterials = new_array<aiMaterial*>(count);
  scene->mRootNode = new aiNode("root");
  for (const ModelObject& object : model.objects) {
    const unsigned index = scene->mNumMeshes;
    scene->mMeshes[scene->mNumMeshes++] = mesh_of(object, index).release();
    scene->mMaterials[scene->mNumMaterials++] = material_of(object.material).release();
    aiNode* node = node_of(object, index).release();
    scene->mRootNode->addChildren(1, &node);
  }
  return scene;
}

}  // namespace

Result<std::string> unrepaired_fbx_bytes(const Model& model) {
  const auto scene = scene_of(model);
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), "fbx", 0U);
  if (blob == nullptr)
    return failure("", std::string("assimp cannot write FBX (") + exporter.GetErrorString() + ")",
                   "export .obj instead");
  return std::string(static_cast<const char*>(blob->data), blob->size);
}

Result<std::string> fbx_bytes(const Model& model) {
  return unrepaired_fbx_bytes(model).and_then(repair_fbx_container);
}

}  // namespace ribbon
