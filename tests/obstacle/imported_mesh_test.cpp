#include "obstacle/imported_mesh.h"

#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <memory>
#include <vector>

namespace ribbon::imported_mesh_test {

aiMesh* triangle_at(const std::vector<aiVector3D>& corners) {
  auto* mesh = new aiMesh;
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = static_cast<unsigned>(corners.size());
  mesh->mVertices = new aiVector3D[corners.size()];
  std::copy(corners.begin(), corners.end(), mesh->mVertices);
  mesh->mNumFaces = 1;
  mesh->mFaces = new aiFace[1];
  mesh->mFaces[0].mNumIndices = 3;
  mesh->mFaces[0].mIndices = new unsigned[3]{0, 1, 2};
  return mesh;
}

aiBone* bone_of(const char* joint, const std::vector<aiVertexWeight>& weights) {
  auto* bone = new aiBone;
  bone->mName = joint;
  bone->mNumWeights = static_cast<unsigned>(weights.size());
  bone->mWeights = new aiVertexWeight[weights.size()];
  std::copy(weights.begin(), weights.end(), bone->mWeights);
  return bone;
}

void hang(aiMesh& mesh, std::initializer_list<aiBone*> bones) {
  mesh.mNumBones = static_cast<unsigned>(bones.size());
  mesh.mBones = new aiBone*[bones.size()];
  std::copy(bones.begin(), bones.end(), mesh.mBones);
}

aiMatrix4x4 moved_by(float x) {
  aiMatrix4x4 matrix;
  matrix.a4 = x;
  return matrix;
}

// A file with one mesh, which its node "rock" shows; joints beside it.
class File : public testing::Test {
 protected:
  File() {
    file_.mMeshes = new aiMesh* [1] { mesh_ };
    file_.mNumMeshes = 1;
    rock_->mNumMeshes = 1;
    rock_->mMeshes = new unsigned[1]{0};
    file_.mRootNode = new aiNode("root");
    file_.mRootNode->addChildren(1, &rock_);
  }

  void add_joint(const char* name, float x) {
    auto* joint = new aiNode(name);
    joint->mTransformation = moved_by(x);
    file_.mRootNode->addChildren(1, &joint);
  }

  [[nodiscard]] TriangleMesh imported() const { return merged_mesh(file_).value(); }

  [[nodiscard]] Eigen::Matrix3f corners() const {
    const TriangleMesh mesh = imported();
    Eigen::Matrix3f corners;
    for (int c = 0; c < 3; ++c) corners.col(c) = mesh.vertices.col(mesh.triangles(c, 0));
    return corners;
  }

  aiMesh* mesh_ = triangle_at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  aiNode* rock_ = new aiNode("rock");
  aiScene file_;
};

using ImportedMesh = File;

TEST_F(ImportedMesh, stands_where_its_node_puts_it) {
  rock_->mTransformation = moved_by(5);
  Eigen::Matrix3f expected;
  expected << 5, 6, 5, 0, 0, 1, 0, 0, 0;
  EXPECT_EQ(corners(), expected);
}

TEST_F(ImportedMesh, that_is_mirrored_keeps_its_outside) {
  rock_->mTransformation.a1 = -1;
  Eigen::Matrix3f expected;
  expected << 0, 0, -1, 0, 1, 0, 0, 0, 0;
  EXPECT_EQ(corners(), expected) << "the normal still points towards z";
}

TEST_F(ImportedMesh, that_hangs_on_joints_goes_with_these_and_not_with_its_node) {
  rock_->mTransformation = moved_by(1000);
  add_joint("left", 10);
  add_joint("right", 20);
  // The weights of the second vertex sum to one half only.
  hang(*mesh_, {bone_of("left", {{0, 1.0F}, {1, 0.5F}, {2, 0.25F}}), bone_of("right", {{2, 0.75F}}),
                bone_of("nowhere", {{1, 0.5F}})});
  Eigen::Matrix3f expected;
  expected << 10, 11, 17.5, 0, 0, 1, 0, 0, 0;
  EXPECT_EQ(corners(), expected);
}

TEST_F(ImportedMesh, of_which_a_vertex_hangs_on_no_joint_leaves_that_with_the_node) {
  rock_->mTransformation = moved_by(1000);
  add_joint("left", 10);
  hang(*mesh_, {bone_of("left", {{0, 1.0F}, {1, 1.0F}})});
  EXPECT_EQ(corners()(0, 2), 1000);
}

TEST_F(ImportedMesh, of_an_fbx_is_turned_to_metres_and_y_up) {
  aiMetadata* told = aiMetadata::Alloc(7);
  told->Set(0, "CoordAxis", std::int32_t{0});
  told->Set(1, "CoordAxisSign", std::int32_t{1});
  told->Set(2, "UpAxis", std::int32_t{2});
  told->Set(3, "UpAxisSign", std::int32_t{1});
  told->Set(4, "FrontAxis", std::int32_t{1});
  told->Set(5, "FrontAxisSign", std::int32_t{-1});
  told->Set(6, "UnitScaleFactor", 25.0F);
  file_.mMetaData = told;
  Eigen::Matrix3f expected;
  expected << 0, 0.25, 0, 0, 0, 0, 0, 0, -0.25;
  EXPECT_EQ(corners(), expected);
  told->Set(2, "UpAxis", std::int32_t{0});  // the same as x
  EXPECT_EQ(corners()(1, 2), 0.25) << "axes that make no sense are not followed";
}

TEST_F(ImportedMesh, that_speaks_of_vertices_which_are_not_there_is_none) {
  mesh_->mFaces[0].mIndices[1] = 3;
  EXPECT_FALSE(merged_mesh(file_));
  mesh_->mFaces[0].mIndices[1] = 1;
  add_joint("left", 10);
  hang(*mesh_, {bone_of("left", {{3, 1.0F}})});
  EXPECT_FALSE(merged_mesh(file_));
}

}  // namespace ribbon::imported_mesh_test
