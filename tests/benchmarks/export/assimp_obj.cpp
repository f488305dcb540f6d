#include "benchmarks/export/assimp_obj.h"

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <memory>

namespace ribbon {

namespace {

// assimp's scenes own their arrays, whose elements must come from new[].
template <class Element>
Element* new_array(std::size_t count) {
  return new Element[count]();
}

aiFace face_of(const Eigen::VectorXi& corners) {
  aiFace face;
  face.mNumIndices = static_cast<unsigned>(corners.size());
  face.mIndices = new_array<unsigned>(face.mNumIndices);
  std::copy(corners.begin(), corners.end(), face.mIndices);
  return face;
}

aiMesh* mesh_of(const ModelObject& object) {
  auto mesh = std::make_unique<aiMesh>();
  mesh->mName.Set(object.name);
  mesh->mPrimitiveTypes = aiPrimitiveType_POLYGON;
  mesh->mNumVertices = static_cast<unsigned>(object.positions.cols());
  mesh->mVertices = new_array<aiVector3D>(mesh->mNumVertices);
  for (unsigned i = 0; i < mesh->mNumVertices; ++i)
    mesh->mVertices[i] = {object.positions(0, i), object.positions(1, i), object.positions(2, i)};
  if (object.uv.cols() > 0) {
    mesh->mNumUVComponents[0] = 2;
    mesh->mTextureCoords[0] = new_array<aiVector3D>(mesh->mNumVertices);
    for (unsigned i = 0; i < mesh->mNumVertices; ++i)
      mesh->mTextureCoords[0][i] = {object.uv(0, i), object.uv(1, i), 0.0F};
  }
  mesh->mNumFaces = static_cast<unsigned>(object.faces.cols());
  mesh->mFaces = new_array<aiFace>(mesh->mNumFaces);
  for (unsigned i = 0; i < mesh->mNumFaces; ++i) mesh->mFaces[i] = face_of(object.faces.col(i));
  return mesh.release();
}

std::unique_ptr<aiScene> scene_of(const Model& model) {
  auto scene = std::make_unique<aiScene>();
  scene->mMeshes = new_array<aiMesh*>(model.objects.size());
  scene->mMaterials = new_array<aiMaterial*>(1);
  scene->mMaterials[scene->mNumMaterials++] = new aiMaterial;
  scene->mRootNode = new aiNode("root");
  scene->mRootNode->mMeshes = new_array<unsigned>(model.objects.size());
  for (const ModelObject& object : model.objects) {
    scene->mRootNode->mMeshes[scene->mRootNode->mNumMeshes++] = scene->mNumMeshes;
    scene->mMeshes[scene->mNumMeshes++] = mesh_of(object);
  }
  return scene;
}

}  // namespace

Result<void> write_obj_by_assimp(const Model& model, const std::filesystem::path& path) {
  Assimp::Exporter exporter;
  if (exporter.Export(scene_of(model).get(), "obj", path.string()) == aiReturn_SUCCESS) return {};
  return failure(path.string(), exporter.GetErrorString(), "choose another folder with --scratch");
}

}  // namespace ribbon
