#include "converter/export/fbx_export.h"

#include <assimp/material.h>
#include <assimp/scene.h>
#include <assimp/version.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>

#include "converter/export/fbx_records.h"
#include "converter/export/posed_model.h"

namespace ribbon::fbx_export_test {

const aiScene* imported(Assimp::Importer& importer, const std::string& bytes) {
  return importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0U, "fbx");
}

// The importer gives every face its own vertices, so faces and corners are compared in order.
void expect_same(const aiMesh& mesh, const ModelObject& object) {
  ASSERT_EQ(mesh.mNumFaces, object.faces.cols());
  ASSERT_EQ(mesh.HasTextureCoords(0), object.uv.cols() > 0);
  for (unsigned face = 0; face < mesh.mNumFaces; ++face) {
    ASSERT_EQ(mesh.mFaces[face].mNumIndices, object.faces.rows());
    for (unsigned corner = 0; corner < mesh.mFaces[face].mNumIndices; ++corner) {
      const unsigned vertex = mesh.mFaces[face].mIndices[corner];
      const int expected = object.faces(corner, face);
      const aiVector3D& position = mesh.mVertices[vertex];
      ASSERT_EQ(Eigen::Vector3f(position.x, position.y, position.z),
                object.positions.col(expected));
      if (object.uv.cols() == 0) continue;
      const aiVector3D& uv = mesh.mTextureCoords[0][vertex];
      ASSERT_EQ(Eigen::Vector2f(uv.x, uv.y), object.uv.col(expected));
    }
  }
}

void expect_read_back(const SampleKnot& knot, std::size_t frame) {
  const Model model = posed_model(knot, frame);
  Assimp::Importer importer;
  const aiScene* scene = imported(importer, fbx_bytes(model).value());
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_EQ(scene->mNumMeshes, model.objects.size());
  for (const ModelObject& object : model.objects) {
    const aiNode* node = scene->mRootNode->FindNode(object.name.c_str());
    ASSERT_NE(node, nullptr) << object.name;
    ASSERT_EQ(node->mNumMeshes, 1U);
    const aiMesh& mesh = *scene->mMeshes[node->mMeshes[0]];
    expect_same(mesh, object);
    EXPECT_STREQ(scene->mMaterials[mesh.mMaterialIndex]->GetName().C_Str(),
                 object.material.name.c_str());
  }
}

TEST(FbxExport, assimp_reads_every_frame_back) {
  for (std::size_t frame = 0; frame < 5; ++frame) expect_read_back(sample_knot(), frame);
}

TEST(FbxExport, coordinates_a_kilometre_away_lose_no_digit) {
  expect_read_back(sample_knot({.along = 12, .across = 4}, {1000, 2000, -3000}), 2);
}

TEST(FbxExport, every_nested_list_ends_with_its_null_record) {
  const std::string bytes = fbx_bytes(posed_model(sample_knot(), 2)).value();
  const std::size_t end = fbx_top_list_end(bytes);
  ASSERT_NE(end, 0U);
  const std::size_t footer_end = bytes.size() - 144;
  EXPECT_EQ(footer_end % 16, 0U);
  EXPECT_GT(footer_end, end + 16);
  EXPECT_LE(footer_end, end + 32);
}

TEST(FbxExport, the_repair_is_needed_only_with_an_assimp_before_5_3) {
  const std::string bytes = unrepaired_fbx_bytes(posed_model(sample_knot(), 0)).value();
  const bool right = fbx_top_list_end(bytes) != 0;
  EXPECT_EQ(right, aiGetVersionMajor() > 5 || aiGetVersionMinor() >= 3);
}

// The number of elements in the array property of the first record with this name.
std::uint32_t array_length(const std::string& bytes, const std::string& name) {
  std::uint32_t length = 0;
  const std::size_t found = bytes.find(static_cast<char>(name.size()) + name);
  if (found == std::string::npos) return 0;
  std::memcpy(&length, bytes.data() + found + 1 + name.size() + 1, sizeof length);
  return length;
}

TEST(FbxExport, coincident_vertices_are_not_joined) {
  const std::string bytes = fbx_bytes(posed_model(sample_knot(), 2)).value();
  EXPECT_EQ(array_length(bytes, "Vertices"), 3 * 48U);
  EXPECT_EQ(array_length(bytes, "PolygonVertexIndex"), 3 * 66U);
}

TEST(FbxExport, the_file_says_metres_y_up_and_the_frame_rate) {
  Assimp::Importer importer;
  const aiScene* scene = imported(importer, fbx_bytes(posed_model(sample_knot(), 0)).value());
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  double unit_cm = 0;
  float unit_cm_float = 0;
  std::int32_t up = -1;
  std::int32_t front = -1;
  EXPECT_TRUE(scene->mMetaData->Get("UpAxis", up));
  EXPECT_TRUE(scene->mMetaData->Get("FrontAxis", front));
  if (!scene->mMetaData->Get("UnitScaleFactor", unit_cm) &&
      scene->mMetaData->Get("UnitScaleFactor", unit_cm_float))
    unit_cm = unit_cm_float;
  EXPECT_EQ(unit_cm, 100);
  EXPECT_EQ(up, 1);
  EXPECT_EQ(front, 2);
  float rate = 0;
  EXPECT_TRUE(scene->mMetaData->Get("CustomFrameRate", rate));
  EXPECT_EQ(rate, 50);
}

}  // namespace ribbon::fbx_export_test
