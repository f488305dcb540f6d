#include "converter/export/fbx_writer.h"

#include <assimp/anim.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <set>

#include "converter/export/read_fbx.h"
#include "model/written_motion.h"
#include "result/refusal.h"

namespace ribbon::fbx_writer_test {

std::string frame_bytes(const SampleKnot& knot, std::size_t frame) {
  return fbx_bytes(posed_model(knot, frame)).value();
}

std::vector<double> numbers(const Eigen::Matrix3Xf& points) {
  return {points.data(), points.data() + points.size()};
}

TEST(FbxFrame, the_file_says_metres_y_up_and_the_frame_rate) {
  const ReadFbxRecord file = read_fbx(frame_bytes(sample_knot(), 0));
  const ReadFbxRecord& settings = file["GlobalSettings"];
  EXPECT_EQ(settings.setting("UnitScaleFactor"), 100);
  EXPECT_EQ(settings.setting("OriginalUnitScaleFactor"), 100);
  EXPECT_EQ(settings.setting("UpAxis"), 1);
  EXPECT_EQ(settings.setting("FrontAxis"), 2);
  EXPECT_EQ(settings.setting("CoordAxis"), 0);
  EXPECT_EQ(settings.setting("TimeMode"), 14);
  EXPECT_EQ(settings.setting("CustomFrameRate"), 50);
}

TEST(FbxFrame, the_file_says_other_axes_and_units) {
  const Placement placement{.up = UpAxis::z, .metres_per_unit = 0.01};
  const Model model = posed_model(sample_knot(), 0, {.placement = placement});
  const ReadFbxRecord file = read_fbx(fbx_bytes(model).value());
  const ReadFbxRecord& settings = file["GlobalSettings"];
  EXPECT_EQ(settings.setting("UnitScaleFactor"), 1);
  EXPECT_EQ(settings.setting("UpAxis"), 2);
  EXPECT_EQ(settings.setting("FrontAxis"), 1);
  EXPECT_EQ(settings.setting("FrontAxisSign"), -1);
}

TEST(FbxFrame, meshes_are_as_in_the_model_and_nothing_moves) {
  const Model model = posed_model(sample_knot(), 2);
  const ReadFbxRecord file = read_fbx(fbx_bytes(model).value());
  const auto meshes = all_in(file["Objects"], "Geometry", "Mesh");
  ASSERT_EQ(meshes.size(), 2U);
  for (std::size_t object = 0; object < 2; ++object) {
    EXPECT_EQ((*meshes[object])["Vertices"].array(), numbers(model.objects[object].positions));
    EXPECT_EQ((*meshes[object])["PolygonVertexIndex"].array().size(),
              static_cast<std::size_t>(model.objects[object].faces.size()));
  }
  EXPECT_TRUE(all_in(file["Objects"], "Geometry", "Shape").empty());
  EXPECT_EQ(file["Objects"]["AnimationStack"].name, "");
}

TEST(FbxFrame, the_same_frame_gives_the_same_bytes) {
  EXPECT_TRUE(frame_bytes(sample_knot(), 1) == frame_bytes(sample_knot(), 1));
}

class FbxMotion : public testing::Test {
 protected:
  SampleKnot knot_ = sample_knot();
  std::string bytes_ = written_motion(new_fbx_writer, knot_);
  ReadFbxRecord file_ = read_fbx(bytes_);
};

TEST_F(FbxMotion, each_further_frame_is_a_shape_of_exact_displacements) {
  const auto shapes = all_in(file_["Objects"], "Geometry", "Shape");
  ASSERT_EQ(shapes.size(), 4U);
  for (std::size_t frame = 1; frame < 5; ++frame) {
    const ReadFbxRecord& shape = *shapes[frame - 1];
    EXPECT_EQ(shape.text(1),
              "frame " + std::to_string(frame + 1) + std::string("\0\1Geometry", 10));
    EXPECT_EQ(shape["Indexes"].array().size(), 48U) << "also where nothing moved";
    const std::vector<double> moved = shape["Vertices"].array();
    const Eigen::Matrix3Xd posed = knot_.frames[0].cast<float>().cast<double>() +
                                   Eigen::Map<const Eigen::Matrix3Xd>(moved.data(), 3, 48);
    EXPECT_EQ(posed, knot_.frames[frame].cast<float>().cast<double>()) << frame;
  }
}

TEST_F(FbxMotion, each_channel_is_full_in_its_frame_alone) {
  constexpr double ticks = 46186158000.0 / 50;
  const auto curves = all_in(file_["Objects"], "AnimationCurve", "");
  ASSERT_EQ(curves.size(), 4U);
  for (std::size_t frame = 1; frame < 5; ++frame) {
    const ReadFbxRecord& curve = *curves[frame - 1];
    const auto at = static_cast<double>(frame);
    std::vector<double> times{(at - 1) * ticks, at * ticks, (at + 1) * ticks};
    std::vector<double> weights{0, 100, 0};
    times.resize(frame < 4 ? 3 : 2);  // the last frame has none behind it
    weights.resize(times.size());
    EXPECT_EQ(curve["KeyTime"].array(), times);
    EXPECT_EQ(curve["KeyValueFloat"].array(), weights);
  }
  for (const ReadFbxRecord* channel : all_in(file_["Objects"], "Deformer", "BlendShapeChannel"))
    EXPECT_EQ((*channel)["FullWeights"].array(), std::vector<double>{100});
}

TEST_F(FbxMotion, ends_with_its_last_frame) {
  constexpr double last = 4 * 46186158000.0 / 50;
  EXPECT_EQ(file_["GlobalSettings"].setting("TimeSpanStop"), last);
  EXPECT_EQ(file_["Objects"]["AnimationStack"].setting("LocalStop"), last);
  EXPECT_EQ(file_["Objects"]["AnimationStack"].setting("ReferenceStop"), last);
}

void expect_all_connected(const ReadFbxRecord& file) {
  std::vector<double> objects;
  for (const ReadFbxRecord& object : file["Objects"].nested)
    objects.push_back(std::get<double>(object.properties[0]));
  std::set<double> connected;  // a curve's node both to its layer and to its channel
  for (const ReadFbxRecord& connection : file["Connections"].nested) {
    connected.insert(std::get<double>(connection.properties[1]));
    const double owner = std::get<double>(connection.properties[2]);
    EXPECT_TRUE(owner == 0 || std::count(objects.begin(), objects.end(), owner) == 1) << owner;
  }
  connected.insert(std::get<double>(file["Objects"]["AnimationStack"].properties[0]));
  EXPECT_THAT(connected, testing::UnorderedElementsAreArray(objects));
}

void expect_all_counted(const ReadFbxRecord& file) {
  double count = 1;  // the settings
  for (const ReadFbxRecord& type : file["Definitions"].nested) {
    if (type.name != "ObjectType" || type.text(0) == "GlobalSettings") continue;
    double found = 0;
    for (const ReadFbxRecord& object : file["Objects"].nested)
      found += object.name == type.text(0) ? 1 : 0;
    EXPECT_EQ(type["Count"].number(), found) << type.text(0);
    count += found;
  }
  EXPECT_EQ(file["Definitions"]["Count"].number(), count);
  EXPECT_EQ(static_cast<double>(file["Objects"].nested.size()), count - 1);
}

TEST_F(FbxMotion, all_that_is_connected_exists_and_all_that_exists_is_connected) {
  expect_all_connected(file_);
}

TEST_F(FbxMotion, the_definitions_count_all_objects) {
  expect_all_counted(file_);
}

TEST(FbxWriter, each_side_of_a_solid_has_a_material_and_a_picture) {
  const ReadFbxRecord file =
      read_fbx(written_motion(new_fbx_writer, knot_with_room(), textured_on_both_sides()));
  expect_all_connected(file);
  expect_all_counted(file);
  EXPECT_EQ(all_in(file["Objects"], "Material", "").size(), 2U);
  EXPECT_EQ(all_in(file["Objects"], "Video", "Clip").size(), 2U);
  const ReadFbxRecord& layer =
      (*all_in(file["Objects"], "Geometry", "Mesh")[0])["LayerElementMaterial"];
  const std::vector<double> shown = layer["Materials"].array();
  ASSERT_EQ(shown.size(), 2 * 66U + 2 * 28U);
  for (std::size_t face = 0; face < shown.size(); ++face)
    EXPECT_EQ(shown[face], face < shown.size() - 66 ? 0 : 1) << face;
}

TEST_F(FbxMotion, one_frame_is_the_same_file_as_without_motion) {
  knot_.frames.resize(1);
  EXPECT_TRUE(written_motion(new_fbx_writer, knot_) == frame_bytes(knot_, 0));
}

TEST(FbxWriter, other_programs_are_warned_of) {
  Model model = posed_model(sample_knot(), 0);
  EXPECT_EQ(fbx_warning(model, 1000), "");
  EXPECT_THAT(fbx_warning(model, 1001), HasSubstr("1001 frames"));
  model.frames_per_second = 29.97;
  EXPECT_EQ(fbx_warning(model, 1), "");
  EXPECT_THAT(fbx_warning(model, 2), AllOf(HasSubstr("29.97"), HasSubstr("as 30")));
}

TEST(FbxWriter, an_unwritable_place_is_named) {
  EXPECT_THAT(refusal_of(new_fbx_writer("/dev/null/a.fbx", posed_model(sample_knot(), 0), 2)),
              HasSubstr("/dev/null"));
}

// The importer gives every face its own vertices, so faces and corners are compared in order.
void expect_same(const aiMesh& mesh, const ModelObject& object) {
  ASSERT_EQ(mesh.mNumFaces, object.faces.cols());
  ASSERT_EQ(mesh.HasTextureCoords(0), object.uv.cols() > 0);
  ASSERT_EQ(mesh.HasNormals(), object.normals.cols() > 0);
  for (unsigned face = 0; face < mesh.mNumFaces; ++face) {
    ASSERT_EQ(mesh.mFaces[face].mNumIndices, object.faces.rows());
    for (unsigned corner = 0; corner < mesh.mFaces[face].mNumIndices; ++corner) {
      const unsigned vertex = mesh.mFaces[face].mIndices[corner];
      const int expected = object.faces(corner, face);
      const aiVector3D& position = mesh.mVertices[vertex];
      ASSERT_EQ(Eigen::Vector3f(position.x, position.y, position.z),
                object.positions.col(expected));
      if (object.normals.cols() > 0) {
        const aiVector3D& normal = mesh.mNormals[vertex];
        ASSERT_EQ(Eigen::Vector3f(normal.x, normal.y, normal.z), object.normals.col(expected));
      }
      if (object.uv.cols() == 0) continue;
      const aiVector3D& uv = mesh.mTextureCoords[0][vertex];
      ASSERT_EQ(Eigen::Vector2f(uv.x, uv.y), object.uv.col(expected));
    }
  }
}

// What another reader makes of the file.
class FbxReadByAssimp : public testing::Test {
 protected:
  void read(const std::string& bytes) {
    scene_ = importer_.ReadFileFromMemory(bytes.data(), bytes.size(), 0U, "fbx");
    ASSERT_NE(scene_, nullptr) << importer_.GetErrorString();
  }

  void expect_meshes_of(const Model& model) {
    ASSERT_EQ(scene_->mNumMeshes, model.objects.size());
    for (const ModelObject& object : model.objects) {
      const aiNode* node = scene_->mRootNode->FindNode(object.name.c_str());
      ASSERT_NE(node, nullptr) << object.name;
      ASSERT_EQ(node->mNumMeshes, 1U);
      const aiMesh& mesh = *scene_->mMeshes[node->mMeshes[0]];
      expect_same(mesh, object);
      EXPECT_STREQ(scene_->mMaterials[mesh.mMaterialIndex]->GetName().C_Str(),
                   object.material.name.c_str());
    }
  }

  Assimp::Importer importer_;
  const aiScene* scene_ = nullptr;
};

TEST_F(FbxReadByAssimp, every_frame_is_exact) {
  for (std::size_t frame = 0; frame < 5; ++frame) {
    read(frame_bytes(sample_knot(), frame));
    expect_meshes_of(posed_model(sample_knot(), frame));
  }
}

TEST_F(FbxReadByAssimp, normals_stand_at_the_vertices) {
  const Model model = posed_model(sample_knot(), 1, {.with_normals = true});
  read(fbx_bytes(model).value());
  expect_meshes_of(model);
}

TEST_F(FbxReadByAssimp, the_picture_is_the_ribbons_diffuse_texture) {
  const Model model = posed_model(sample_knot(), 2, textured());
  read(fbx_bytes(model).value());
  expect_meshes_of(model);
  for (unsigned i = 0; i < scene_->mNumMaterials; ++i) {
    const aiMaterial& material = *scene_->mMaterials[i];
    aiString file;
    const bool has_picture =
        material.GetTexture(aiTextureType_DIFFUSE, 0, &file) == aiReturn_SUCCESS;
    EXPECT_EQ(has_picture, material.GetName() == aiString("ribbon"));
    EXPECT_STREQ(file.C_Str(), has_picture ? "knot.png" : "");
  }
}

TEST_F(FbxReadByAssimp, quads_stay_quads) {
  const Model quads = posed_model(sample_knot(), 2, {.faces = RibbonFaces::quads});
  read(fbx_bytes(quads).value());
  expect_meshes_of(quads);
}

TEST_F(FbxReadByAssimp, coordinates_a_kilometre_away_lose_no_digit) {
  const SampleKnot far = sample_knot({.along = 12, .across = 4}, {1000, 2000, -3000});
  read(frame_bytes(far, 2));
  expect_meshes_of(posed_model(far, 2));
}

// `vectors` stand at the corners of the mesh's faces, `expected` at the object's vertices.
void expect_close(const aiVector3D* vectors, const Eigen::Matrix3Xf& expected, const aiMesh& mesh,
                  const ModelObject& object, float tolerance) {
  ASSERT_NE(vectors, nullptr);
  for (unsigned face = 0; face < mesh.mNumFaces; ++face)
    for (unsigned corner = 0; corner < mesh.mFaces[face].mNumIndices; ++corner) {
      const aiVector3D& at = vectors[mesh.mFaces[face].mIndices[corner]];
      EXPECT_LE((Eigen::Vector3f(at.x, at.y, at.z) - expected.col(object.faces(corner, face)))
                    .cwiseAbs()
                    .maxCoeff(),
                tolerance);
    }
}

TEST_F(FbxReadByAssimp, every_shape_of_the_motion_is_there) {
  const SampleKnot knot = sample_knot();
  const ModelSettings settings{.with_normals = true};
  read(written_motion(new_fbx_writer, knot, settings));
  expect_meshes_of(posed_model(knot, 0, settings));
  const aiMesh& ribbon = *scene_->mMeshes[scene_->mRootNode->FindNode("first knot")->mMeshes[0]];
  ASSERT_EQ(ribbon.mNumAnimMeshes, 4U);
  for (std::size_t frame = 1; frame < 5; ++frame) {
    const ModelObject posed = posed_model(knot, frame, settings).objects[0];
    const aiAnimMesh& shape = *ribbon.mAnimMeshes[frame - 1];
    expect_close(shape.mVertices, posed.positions, ribbon, posed, 1e-7F);
    expect_close(shape.mNormals, posed.normals, ribbon, posed, 1e-6F);
  }
}

TEST_F(FbxReadByAssimp, unit_axes_and_frame_rate_are_understood) {
  read(frame_bytes(sample_knot(), 0));
  float unit_cm = 0;
  std::int32_t up = -1;
  std::int32_t front = -1;
  float rate = 0;
  EXPECT_TRUE(scene_->mMetaData->Get("UpAxis", up));
  EXPECT_TRUE(scene_->mMetaData->Get("FrontAxis", front));
  EXPECT_TRUE(scene_->mMetaData->Get("UnitScaleFactor", unit_cm));
  EXPECT_TRUE(scene_->mMetaData->Get("CustomFrameRate", rate));
  EXPECT_EQ(unit_cm, 100);
  EXPECT_EQ(up, 1);
  EXPECT_EQ(front, 2);
  EXPECT_EQ(rate, 50);
}

}  // namespace ribbon::fbx_writer_test
