// Files that leave the page.
#include "recorder/page/taken_away.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files/temporary_folder.h"
#include "obstacle/obstacle.h"
#include "recorder/record.h"
#include "recorder/small_scene.h"
#include "recorder/test_runs.h"

namespace ribbon::taken_away_test {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class TakenAway : public TestInFolder {
 protected:
  TakenAway() {
    const Scene scene = read_scene(write_small_scene(folder_)).value();
    (void)record(scene, replacing(recording_), goes_on).value();
  }

  std::string text(const std::string& name) { return read_file(folder_ / name).value(); }

  std::filesystem::path recording_ = folder_ / "knot.rbn";
};

TEST_F(TakenAway, a_frame_is_a_shape_with_its_materials_beside_it) {
  ASSERT_TRUE(write_shape(recording_, 3, folder_ / "knot.obj"));
  EXPECT_THAT(text("knot.obj"), HasSubstr("mtllib knot.mtl"));
  EXPECT_THAT(text("knot.mtl"), HasSubstr("newmtl"));
  ASSERT_TRUE(write_shape(recording_, 6, folder_ / "later.obj"));
  EXPECT_NE(text("later.obj"), text("knot.obj"));
}

TEST_F(TakenAway, a_motion_holds_all_frames) {
  ASSERT_TRUE(write_motion(recording_, folder_ / "knot.glb"));
  EXPECT_THAT(text("knot.glb"), StartsWith("glTF"));
  ASSERT_TRUE(write_shape(recording_, 0, folder_ / "knot.obj"));
  EXPECT_GT(text("knot.glb").size(), text("knot.obj").size());
}

TEST_F(TakenAway, what_is_no_recording_is_refused) {
  ASSERT_TRUE(write_file(folder_ / "other.rbn", "no recording"));
  for (const auto& refused : {write_shape(folder_ / "other.rbn", 0, folder_ / "knot.obj"),
                              write_motion(folder_ / "other.rbn", folder_ / "knot.glb")}) {
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().sentence(), HasSubstr("other.rbn"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "knot.obj"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "knot.glb"));
}

TEST_F(TakenAway, an_object_has_the_same_vertices_when_it_is_read_again) {
  TriangleMesh object;
  object.name = "post";
  object.vertices.resize(3, 4);
  object.vertices << 0, 0.1F, 0, 1.0F / 3, 0, 0, 1e-7F, 0, 0, 0, 0, -12345.678F;
  object.triangles.resize(3, 4);
  object.triangles << 0, 0, 0, 1, 1, 2, 3, 2, 2, 3, 1, 3;
  ASSERT_TRUE(write_object(object, folder_ / "post.obj"));
  const TriangleMesh read = read_obstacle(ObstacleScene{.file = {folder_ / "post.obj"}}).value();
  EXPECT_EQ(read.vertices, object.vertices);
  EXPECT_EQ(read.triangles, object.triangles);
}

}  // namespace ribbon::taken_away_test
