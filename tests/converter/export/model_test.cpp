#include "converter/export/model.h"

#include <gtest/gtest.h>

#include <limits>

#include "converter/export/posed_model.h"
#include "result/refusal.h"

namespace ribbon::model_test {

TEST(Model, ribbon_and_obstacle_are_named_objects_with_materials) {
  const Model model = model_of_recording(sample_knot().header, true).value();
  ASSERT_EQ(model.objects.size(), 2U);
  EXPECT_EQ(model.objects[0].name, "first knot");
  EXPECT_EQ(model.objects[0].material.name, "ribbon");
  EXPECT_EQ(model.objects[0].faces.rows(), 4);
  EXPECT_EQ(model.objects[1].name, "small object");
  EXPECT_EQ(model.objects[1].faces.rows(), 3);
  EXPECT_EQ(model.objects[1].uv.cols(), 0);
}

TEST(Model, the_obstacle_can_be_left_out) {
  EXPECT_EQ(model_of_recording(sample_knot().header, false).value().objects.size(), 1U);
}

TEST(Model, a_ribbon_without_obstacle_is_alone) {
  RecordingHeader header = sample_knot().header;
  header.obstacle.reset();
  EXPECT_EQ(model_of_recording(header, true).value().objects.size(), 1U);
}

TEST(Model, names_become_one_line_of_at_most_63_bytes) {
  RecordingHeader header = sample_knot().header;
  header.scene_name = " a\nb\tc ";
  header.obstacle->name = std::string(62, 'x') + "\xc3\xa4";  // a two-byte letter across the end
  const Model model = model_of_recording(header, true).value();
  EXPECT_EQ(model.objects[0].name, "a_b_c");
  EXPECT_EQ(model.objects[1].name, std::string(62, 'x'));
}

TEST(Model, objects_never_share_a_name) {
  RecordingHeader header = sample_knot().header;
  header.obstacle->name = header.scene_name;
  EXPECT_EQ(model_of_recording(header, true).value().objects[1].name, "obstacle");
  header.scene_name = header.obstacle->name = "obstacle";
  EXPECT_NE(model_of_recording(header, true).value().objects[1].name, "obstacle");
}

TEST(Model, an_obstacle_triangle_without_its_vertex_is_refused) {
  RecordingHeader header = sample_knot().header;
  header.obstacle->triangles(1, 2) = 5;
  EXPECT_FALSE(model_of_recording(header, true).has_value());
}

TEST(Model, uv_for_fewer_particles_is_refused) {
  RecordingHeader header = sample_knot().header;
  header.uv.conservativeResize(2, 47);
  EXPECT_FALSE(model_of_recording(header, true).has_value());
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

}  // namespace ribbon::model_test
