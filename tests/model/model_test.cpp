#include "model/model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "model/posed_model.h"
#include "result/refusal.h"

namespace ribbon::model_test {

TEST(Model, ribbon_and_obstacle_are_named_objects_with_materials) {
  const Model model = model_of_recording(sample_knot().header, {}).value();
  ASSERT_EQ(model.objects.size(), 2U);
  EXPECT_EQ(model.objects[0].name, "first knot");
  EXPECT_EQ(model.objects[0].material.name, "ribbon");
  EXPECT_TRUE(model.objects[0].moves);
  EXPECT_FALSE(model.objects[1].moves);
  EXPECT_EQ(model.objects[1].name, "small object");
  EXPECT_EQ(model.objects[1].faces.rows(), 3);
  EXPECT_EQ(model.objects[1].uv.cols(), 0);
}

TEST(Model, the_ribbon_has_the_triangles_that_the_recording_certifies) {
  const RecordingHeader header = sample_knot().header;
  EXPECT_EQ(model_of_recording(header, {}).value().objects[0].faces, header.grid.triangles());
}

TEST(Model, a_fan_splits_its_quads_into_those_triangles) {
  const RecordingHeader header = sample_knot().header;
  const Eigen::MatrixXi quads =
      model_of_recording(header, {.faces = RibbonFaces::quads}).value().objects[0].faces;
  ASSERT_EQ(quads.rows(), 4);
  ASSERT_EQ(quads.cols(), header.grid.quad_count());
  for (int q = 0; q < quads.cols(); ++q) {
    std::array diagonal = {quads(0, q), quads(2, q)};
    std::sort(diagonal.begin(), diagonal.end());
    EXPECT_EQ(diagonal, header.grid.diagonal(q)) << q;
  }
}

TEST(Model, the_ribbon_can_be_left_out) {
  const Model model = model_of_recording(sample_knot().header, {.with_ribbon = false}).value();
  ASSERT_EQ(model.objects.size(), 1U);
  EXPECT_EQ(model.objects[0].name, "small object");
}

TEST(Model, nothing_to_export_is_refused) {
  RecordingHeader header = sample_knot().header;
  header.obstacle.reset();
  EXPECT_THAT(refusal_of(model_of_recording(header, {.with_ribbon = false})),
              HasSubstr("no obstacle"));
}

TEST(Model, the_stated_frame_rate_can_be_another) {
  const RecordingHeader header = sample_knot().header;
  EXPECT_EQ(model_of_recording(header, {}).value().frames_per_second, 50);
  EXPECT_EQ(model_of_recording(header, {.frames_per_second = 24}).value().frames_per_second, 24);
}

TEST(Model, ribbon_and_obstacle_are_placed_alike) {
  const SampleKnot knot = sample_knot();
  const Placement placement{.up = UpAxis::z, .metres_per_unit = 0.01};
  Model model = model_of_recording(knot.header, {.placement = placement}).value();
  const Eigen::Matrix3Xf recorded = knot.frames[1].cast<float>();
  ASSERT_TRUE(pose_ribbon(model, recorded, 2));
  EXPECT_EQ(model.objects[0].positions, placement.place(recorded));
  EXPECT_EQ(model.objects[1].positions, placement.place(knot.header.obstacle->vertices));
}

TEST(Model, a_position_that_grows_beyond_all_numbers_names_its_frame) {
  const SampleKnot knot = sample_knot();
  Model model = model_of_recording(knot.header, {.placement = {.scale = 1e39}}).value_or(Model{});
  EXPECT_TRUE(model.objects.empty()) << "the obstacle is infinite";
  model = model_of_recording(knot.header, {.with_obstacle = false, .placement = {.scale = 1e39}})
              .value();
  EXPECT_THAT(refusal_of(pose_ribbon(model, knot.frames[1].cast<float>(), 2)),
              StartsWith("frame 2: "));
}

TEST(Model, a_unit_whose_rounding_could_close_the_stated_gap_is_refused) {
  SampleKnot knot = sample_knot({.along = 12, .across = 4}, {1000, 2000, -3000});
  const ModelSettings centimetres{.with_obstacle = false, .placement = {.metres_per_unit = 0.01}};
  const auto posed = [&](double gap_m) {
    knot.header.stated_gap_m = gap_m;
    Model model = model_of_recording(knot.header, centimetres).value();
    return pose_ribbon(model, knot.frames[1].cast<float>(), 2);
  };
  EXPECT_TRUE(posed(0));  // nothing is stated
  EXPECT_TRUE(posed(1e-3));
  EXPECT_THAT(refusal_of(posed(1e-4)), AllOf(StartsWith("frame 2: "), HasSubstr("--unit")));
}

TEST(Model, an_obstacle_that_is_rounded_too_coarsely_is_refused) {
  SampleKnot knot = sample_knot({.along = 12, .across = 4}, {1000, 2000, -3000});
  knot.header.stated_gap_m = 1e-4;
  EXPECT_TRUE(model_of_recording(knot.header, {}));
  EXPECT_FALSE(model_of_recording(knot.header, {.placement = {.scale = 0.3}}));
}

TEST(Model, normals_are_there_only_where_they_are_asked_for) {
  const SampleKnot knot = sample_knot();
  EXPECT_EQ(posed_model(knot, 1).objects[0].normals.cols(), 0);
  Model model = model_of_recording(knot.header, {.with_normals = true}).value();
  ASSERT_TRUE(pose_ribbon(model, knot.frames[1].cast<float>(), 2));
  for (const ModelObject& object : model.objects) {
    ASSERT_EQ(object.normals.cols(), object.positions.cols());
    for (const auto& normal : object.normals.colwise()) EXPECT_NEAR(normal.norm(), 1, 1e-6);
  }
}

TEST(Model, the_obstacle_can_be_left_out) {
  EXPECT_EQ(
      model_of_recording(sample_knot().header, {.with_obstacle = false}).value().objects.size(),
      1U);
}

TEST(Model, a_ribbon_without_obstacle_is_alone) {
  RecordingHeader header = sample_knot().header;
  header.obstacle.reset();
  EXPECT_EQ(model_of_recording(header, {}).value().objects.size(), 1U);
}

TEST(Model, names_become_one_line_of_at_most_63_bytes) {
  RecordingHeader header = sample_knot().header;
  header.scene_name = " a\nb\tc ";
  header.obstacle->name = std::string(62, 'x') + "\xc3\xa4";  // a two-byte letter across the end
  const Model model = model_of_recording(header, {}).value();
  EXPECT_EQ(model.objects[0].name, "a_b_c");
  EXPECT_EQ(model.objects[1].name, std::string(62, 'x'));
}

TEST(Model, objects_never_share_a_name) {
  RecordingHeader header = sample_knot().header;
  header.obstacle->name = header.scene_name;
  EXPECT_EQ(model_of_recording(header, {}).value().objects[1].name, "obstacle");
  header.scene_name = header.obstacle->name = "obstacle";
  EXPECT_NE(model_of_recording(header, {}).value().objects[1].name, "obstacle");
}

TEST(Model, an_obstacle_without_triangles_is_none) {
  RecordingHeader header = sample_knot().header;
  header.obstacle->triangles.resize(3, 0);
  EXPECT_EQ(model_of_recording(header, {}).value().objects.size(), 1U);
  EXPECT_THAT(refusal_of(model_of_recording(header, {.with_ribbon = false})),
              HasSubstr("no obstacle"));
}

TEST(Model, an_obstacle_triangle_without_its_vertex_is_refused) {
  RecordingHeader header = sample_knot().header;
  header.obstacle->triangles(1, 2) = 5;
  EXPECT_FALSE(model_of_recording(header, {}).has_value());
}

TEST(Model, uv_for_fewer_particles_is_refused) {
  RecordingHeader header = sample_knot().header;
  header.uv.conservativeResize(2, 47);
  EXPECT_FALSE(model_of_recording(header, {}).has_value());
}

TEST(Model, a_position_that_is_not_a_number_names_its_frame) {
  const SampleKnot knot = sample_knot();
  Model model = posed_model(knot, 0);
  Eigen::Matrix3Xf positions = knot.frames[1].cast<float>();
  positions(1, 17) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(refusal_of(pose_ribbon(model, positions, 2)),
              AllOf(StartsWith("frame 2: "), HasSubstr("17")));
  EXPECT_TRUE(model.objects[0].positions.allFinite()) << "the model took the bad frame";
}

TEST(Model, a_changed_particle_count_names_its_frame) {
  const SampleKnot knot = sample_knot();
  Model model = posed_model(knot, 0);
  const Eigen::Matrix3Xf fewer = knot.frames[1].leftCols(47).cast<float>();
  EXPECT_THAT(refusal_of(pose_ribbon(model, fewer, 7)), StartsWith("frame 7: "));
}

TEST(Model, a_picture_as_high_as_the_ribbon_is_wide_is_repeated_along_it) {
  const RecordingHeader header = sample_knot().header;  // 1.1 m x 0.09 m
  const ModelObject ribbon = model_of_recording(header, textured()).value().objects[0];
  EXPECT_TRUE(ribbon.uv.row(1) == header.uv.row(1));
  EXPECT_EQ(ribbon.uv(0, 0), 0);
  EXPECT_FLOAT_EQ(ribbon.uv(0, ribbon.uv.cols() - 1), 1.1F / 0.18F);
  EXPECT_EQ(ribbon.material.color, Eigen::Vector3f::Ones()) << "it would tint the picture";
}

TEST(Model, the_back_of_a_solid_has_a_picture_of_its_own) {
  const RecordingHeader header = knot_with_room().header;  // 1.1 m x 0.09 m
  const ModelObject solid = model_of_recording(header, textured_on_both_sides()).value().objects[0];
  EXPECT_FLOAT_EQ(solid.uv(0, 47), 1.1F / 0.18F);
  EXPECT_FLOAT_EQ(solid.uv(0, 95), 1.1F / 0.27F) << "as high as the ribbon is wide, too";
  const std::vector<ModelPart> parts = parts_of(solid);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].material.name, "ribbon");
  EXPECT_EQ(parts[1].material.name, "ribbon_back");
  EXPECT_EQ(parts[0].faces + parts[1].faces, solid.faces.cols());
  EXPECT_GE(solid.faces.middleCols(parts[1].first_face, parts[1].faces).minCoeff(), 48)
      << "the back's faces have vertices of the back alone";
  EXPECT_EQ(parts[1].faces, 2 * 33);
}

TEST(Model, a_solid_with_one_picture_is_one_part) {
  ModelSettings settings = textured_on_both_sides();
  settings.back_picture = nullptr;
  const Model model = model_of_recording(knot_with_room().header, settings).value();
  EXPECT_EQ(parts_of(model.objects[0]).size(), 1U);
  EXPECT_EQ(materials_of(model).size(), 1U);
}

}  // namespace ribbon::model_test
