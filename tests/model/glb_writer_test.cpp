#include "model/glb_writer.h"

#include <assimp/anim.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "model/written_motion.h"
#include "result/refusal.h"

namespace ribbon::glb_writer_test {

using Json = nlohmann::json;

std::uint32_t u32_at(const std::string& bytes, std::size_t offset) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

// A file taken to pieces as the specification says, every length checked.
struct Glb {
  explicit Glb(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(u32_at(bytes, 4), 2U);
    EXPECT_EQ(u32_at(bytes, 8), bytes.size());
    const std::size_t json_bytes = u32_at(bytes, 12);
    EXPECT_EQ(json_bytes % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    json = Json::parse(bytes.substr(20, json_bytes));
    const std::size_t binary = 20 + json_bytes;
    EXPECT_EQ(u32_at(bytes, binary) + binary + 8, bytes.size());
    EXPECT_EQ(bytes.substr(binary + 4, 4), std::string("BIN\0", 4));
    numbers = bytes.substr(binary + 8);
    EXPECT_EQ(json["buffers"],
              Json::parse(R"([{"byteLength":)" + std::to_string(numbers.size()) + "}]"));
  }

  [[nodiscard]] Eigen::Matrix3Xf vectors(std::size_t index) const {
    const Json& accessor = json["accessors"][index];
    const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const auto offset = accessor.value("byteOffset", std::size_t{0});
    Eigen::Matrix3Xf vectors(3, accessor["count"].get<Eigen::Index>());
    const std::size_t bytes = static_cast<std::size_t>(vectors.size()) * sizeof(float);
    EXPECT_LE(offset + bytes, view["byteLength"].get<std::size_t>());
    std::memcpy(vectors.data(), numbers.data() + view["byteOffset"].get<std::size_t>() + offset,
                bytes);
    return vectors;
  }

  // The points of an accessor, whose bounds must be as it says.
  [[nodiscard]] Eigen::Matrix3Xf points(std::size_t index) const {
    const Json& accessor = json["accessors"][index];
    Eigen::Matrix3Xf points = vectors(index);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(accessor["min"][axis].get<float>(), points.row(axis).minCoeff());
      EXPECT_EQ(accessor["max"][axis].get<float>(), points.row(axis).maxCoeff());
    }
    return points;
  }

  Json json;
  std::string numbers;
};

Eigen::Matrix3Xf positions_of(const SampleKnot& knot, std::size_t frame) {
  return knot.frames[frame].cast<float>();
}

TEST(GlbWriter, each_further_frame_is_a_target_of_displacements) {
  const SampleKnot knot = sample_knot();
  const Glb glb(written_motion(new_glb_writer, knot));
  const Json& ribbon = glb.json["meshes"][0]["primitives"][0];
  EXPECT_EQ(glb.points(ribbon["attributes"]["POSITION"]), positions_of(knot, 0));
  ASSERT_EQ(ribbon["targets"].size(), 4U);
  for (std::size_t frame = 1; frame < 5; ++frame)
    EXPECT_EQ(glb.points(ribbon["targets"][frame - 1]["POSITION"]),
              positions_of(knot, frame) - positions_of(knot, 0));
  EXPECT_EQ(glb.json["meshes"][0]["extras"]["targetNames"],
            Json::parse(R"(["frame 2","frame 3","frame 4","frame 5"])"));
}

TEST(GlbWriter, normals_change_with_the_frames) {
  const SampleKnot knot = sample_knot();
  const ModelSettings with_normals{.with_normals = true};
  const Glb glb(written_motion(new_glb_writer, knot, with_normals));
  const Json& ribbon = glb.json["meshes"][0]["primitives"][0];
  const Eigen::Matrix3Xf first = glb.vectors(ribbon["attributes"]["NORMAL"]);
  EXPECT_TRUE(first == posed_model(knot, 0, with_normals).objects[0].normals);
  ASSERT_EQ(ribbon["targets"].size(), 4U);
  for (std::size_t frame = 1; frame < 5; ++frame) {
    const Json& target = ribbon["targets"][frame - 1];
    EXPECT_TRUE(glb.points(target["POSITION"]) ==
                positions_of(knot, frame) - positions_of(knot, 0));
    const Model posed = posed_model(knot, frame, with_normals);
    EXPECT_TRUE((first + glb.vectors(target["NORMAL"])).isApprox(posed.objects[0].normals, 1e-6F));
  }
  EXPECT_TRUE(glb.json["meshes"][1]["primitives"][0]["attributes"].contains("NORMAL"));
}

TEST(GlbWriter, one_frame_is_a_mesh_without_targets_weights_or_animation) {
  SampleKnot knot = sample_knot();
  knot.frames.resize(1);
  const Glb glb(written_motion(new_glb_writer, knot));
  EXPECT_FALSE(glb.json.contains("animations"));
  for (const Json& mesh : glb.json["meshes"]) {
    EXPECT_FALSE(mesh.contains("weights") || mesh.contains("extras"));
    EXPECT_FALSE(mesh["primitives"][0].contains("targets"));
  }
}

TEST(GlbWriter, the_views_fill_the_binary_chunk_without_a_gap) {
  const Glb glb(written_motion(new_glb_writer, sample_knot()));
  std::size_t end = 0;
  for (const Json& view : glb.json["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"], end);
    end += view["byteLength"].get<std::size_t>();
  }
  EXPECT_EQ(end, glb.numbers.size());
}

TEST(GlbWriter, the_picture_lies_in_the_file_between_mesh_and_motion) {
  const Glb glb(written_motion(new_glb_writer, sample_knot(), textured()));
  const auto texture = glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  EXPECT_EQ(texture["index"], 0);
  EXPECT_FALSE(glb.json["materials"][1]["pbrMetallicRoughness"].contains("baseColorTexture"));
  EXPECT_EQ(glb.json["textures"], Json::parse(R"([{"sampler":0,"source":0}])"));
  EXPECT_EQ(glb.json["images"][0]["mimeType"], "image/png");
  const Json& view =
      glb.json["bufferViews"][glb.json["images"][0]["bufferView"].get<std::size_t>()];
  const auto begin = view["byteOffset"].get<std::size_t>();
  EXPECT_EQ(glb.numbers.substr(begin, view["byteLength"].get<std::size_t>()), sample_png());
  ASSERT_NE(sample_png().size() % 4, 0U) << "nothing is filled up";
  const SampleKnot knot = sample_knot();
  const Json& ribbon = glb.json["meshes"][0]["primitives"][0];
  EXPECT_EQ(glb.points(ribbon["targets"][3]["POSITION"]),
            positions_of(knot, 4) - positions_of(knot, 0));
}

TEST(GlbWriter, each_side_of_a_solid_is_a_primitive_with_a_picture) {
  const Glb glb(written_motion(new_glb_writer, knot_with_room(), textured_on_both_sides()));
  const Json& primitives = glb.json["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 2U);
  EXPECT_EQ(primitives[0]["attributes"], primitives[1]["attributes"]);
  EXPECT_EQ(primitives[0]["targets"], primitives[1]["targets"]);
  EXPECT_EQ(glb.json["accessors"][primitives[1]["indices"].get<std::size_t>()]["count"], 3 * 66);
  for (const int side : {0, 1}) {
    const Json& material = glb.json["materials"][primitives[side]["material"].get<std::size_t>()];
    EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorTexture"]["index"], side);
    EXPECT_EQ(glb.json["textures"][side]["source"], side);
  }
  EXPECT_EQ(glb.json["images"].size(), 2U);
}

TEST(GlbWriter, without_a_picture_there_are_no_textures) {
  const Glb glb(written_motion(new_glb_writer, sample_knot()));
  for (const char* member : {"textures", "images", "samplers"})
    EXPECT_FALSE(glb.json.contains(member)) << member;
}

TEST(GlbWriter, names_are_escaped) {
  SampleKnot knot = sample_knot();
  knot.header.scene_name = R"(a "knot"\)";
  const Glb glb(written_motion(new_glb_writer, knot));
  EXPECT_EQ(glb.json["nodes"][0]["name"], knot.header.scene_name);
  EXPECT_EQ(glb.json["meshes"][1]["name"], "small object");
}

TEST(GlbWriter, the_same_frames_give_the_same_bytes) {
  EXPECT_TRUE(written_motion(new_glb_writer, sample_knot()) ==
              written_motion(new_glb_writer, sample_knot()));
}

// What another reader makes of the file.
class GlbReadByAssimp : public testing::Test {
 protected:
  void read(const SampleKnot& knot, const ModelSettings& settings = {}) {
    const std::string bytes = written_motion(new_glb_writer, knot, settings);
    scene_ = importer_.ReadFileFromMemory(bytes.data(), bytes.size(), 0U, "glb");
    ASSERT_NE(scene_, nullptr) << importer_.GetErrorString();
  }

  [[nodiscard]] const aiMesh& mesh(const char* node) const {
    return *scene_->mMeshes[scene_->mRootNode->FindNode(node)->mMeshes[0]];
  }

  Assimp::Importer importer_;
  const aiScene* scene_ = nullptr;
};

Eigen::Matrix3Xf columns(const aiVector3D* points, unsigned count) {
  Eigen::Matrix3Xf columns(3, count);
  for (unsigned i = 0; i < count; ++i) columns.col(i) << points[i].x, points[i].y, points[i].z;
  return columns;
}

TEST_F(GlbReadByAssimp, positions_of_all_frames_are_there) {
  const SampleKnot knot = sample_knot();
  read(knot);
  const aiMesh& ribbon = mesh("first knot");
  ASSERT_EQ(ribbon.mNumVertices, 48U);
  EXPECT_EQ(columns(ribbon.mVertices, 48), positions_of(knot, 0));
  ASSERT_EQ(ribbon.mNumAnimMeshes, 4U);
  for (std::size_t frame = 1; frame < 5; ++frame) {
    const Eigen::Matrix3Xf posed = columns(ribbon.mAnimMeshes[frame - 1]->mVertices, 48);
    EXPECT_LE((posed - positions_of(knot, frame)).cwiseAbs().maxCoeff(), 1e-7F);
  }
  EXPECT_EQ(columns(mesh("small object").mVertices, 5), knot.header.obstacle->vertices);
}

TEST_F(GlbReadByAssimp, nodes_bring_other_axes_and_units_back) {
  const SampleKnot knot = sample_knot();
  read(knot, {.placement = {.up = UpAxis::z, .metres_per_unit = 0.01}});
  const aiMatrix4x4 to_scene = scene_->mRootNode->FindNode("first knot")->mTransformation;
  const aiMesh& ribbon = mesh("first knot");
  for (unsigned p = 0; p < ribbon.mNumVertices; ++p) {
    const aiVector3D at = to_scene * ribbon.mVertices[p];
    EXPECT_LE((Eigen::Vector3f(at.x, at.y, at.z) - positions_of(knot, 0).col(p)).norm(), 1e-6F);
  }
}

TEST_F(GlbReadByAssimp, quads_are_split_into_the_certified_triangles) {
  const SampleKnot knot = sample_knot();
  read(knot, {.faces = RibbonFaces::quads});
  std::set<std::set<unsigned>> triangles;
  const aiMesh& ribbon = mesh("first knot");
  for (unsigned face = 0; face < ribbon.mNumFaces; ++face)
    triangles.emplace(ribbon.mFaces[face].mIndices, ribbon.mFaces[face].mIndices + 3);
  std::set<std::set<unsigned>> certified;
  for (int t = 0; t < knot.header.grid.triangle_count(); ++t) {
    const auto corners = knot.header.grid.triangle(t);
    certified.emplace(corners.begin(), corners.end());
  }
  EXPECT_EQ(triangles, certified);
}

TEST_F(GlbReadByAssimp, uv_triangles_and_material_are_there) {
  const SampleKnot knot = sample_knot();
  read(knot);
  const aiMesh& ribbon = mesh("first knot");
  EXPECT_EQ(ribbon.mNumFaces, 2U * knot.header.grid.quad_count());
  for (unsigned p = 0; p < ribbon.mNumVertices; ++p) {
    EXPECT_EQ(ribbon.mTextureCoords[0][p].x, knot.header.uv(0, p));
    EXPECT_NEAR(ribbon.mTextureCoords[0][p].y, knot.header.uv(1, p), 1e-7);
  }
  EXPECT_STREQ(scene_->mMaterials[ribbon.mMaterialIndex]->GetName().C_Str(), "ribbon");
}

TEST_F(GlbReadByAssimp, each_frame_gives_its_own_target_the_whole_weight) {
  read(sample_knot());
  ASSERT_EQ(scene_->mNumAnimations, 1U);
  ASSERT_EQ(scene_->mAnimations[0]->mNumMorphMeshChannels, 1U);
  const aiMeshMorphAnim& motion = *scene_->mAnimations[0]->mMorphMeshChannels[0];
  ASSERT_EQ(motion.mNumKeys, 5U);
  for (unsigned frame = 0; frame < 5; ++frame) {
    const aiMeshMorphKey& key = motion.mKeys[frame];
    EXPECT_NEAR(key.mTime, 1000 * frame / 50.0, 1e-3);  // assimp counts milliseconds
    ASSERT_EQ(key.mNumValuesAndWeights, 4U);
    for (unsigned target = 0; target < 4; ++target)
      EXPECT_EQ(key.mWeights[target], target + 1 == frame ? 1 : 0) << frame;
  }
}

TEST(GlbWriter, more_than_the_format_can_hold_is_refused_before_anything_is_written) {
  const auto path = temporary_file("glb") / "a.glb";
  EXPECT_THAT(refusal_of(new_glb_writer(path, posed_model(sample_knot(), 0), 65537)),
              AllOf(HasSubstr("a.glb"), HasSubstr("65536 frames")));
  const SampleKnot large = sample_knot({.along = 600, .across = 10});
  EXPECT_THAT(refusal_of(new_glb_writer(path, posed_model(large, 0), 65536)),
              AllOf(HasSubstr("4.7 GB"), HasSubstr("--frames")));
  EXPECT_FALSE(std::filesystem::exists(path.parent_path()));
}

// Positions are floats as they stand; their differences are not.
TEST(GlbWriter, displacements_that_could_close_the_gap_are_refused) {
  Model first = posed_model(sample_knot(), 0);
  Model second = posed_model(sample_knot(), 1);
  for (Model* model : {&first, &second}) model->objects.front().positions.array() += 500;
  const double rounding_m = std::sqrt(3) * 500 * 0x1p-24;
  for (const double gap_m : {0.0, 3 * rounding_m, 1.9 * rounding_m}) {
    first.stated_gap_m = gap_m;
    auto writer = new_glb_writer(temporary_file("far.glb"), first, 2).value();
    ASSERT_TRUE(writer->append(first));
    const auto appended = writer->append(second);
    EXPECT_EQ(appended.has_value(), gap_m != 1.9 * rounding_m);
    if (!appended) {
      EXPECT_THAT(refusal_of(appended),
                  AllOf(HasSubstr("far.glb: displacements round coordinates by"),
                        EndsWith("write a format that holds positions, as .obj")));
    }
  }
}

TEST(GlbWriter, an_unwritable_place_is_named) {
  EXPECT_THAT(refusal_of(new_glb_writer("/dev/null/a.glb", posed_model(sample_knot(), 0), 2)),
              HasSubstr("/dev/null"));
}

}  // namespace ribbon::glb_writer_test
