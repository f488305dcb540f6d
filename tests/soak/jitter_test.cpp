#include "soak/jitter.h"

#include <gtest/gtest.h>

#include "curve/space_curve.h"
#include "files/files.h"
#include "recording/sample_recording.h"
#include "ribbon_mesh/marks.h"
#include "scene/scene.h"

namespace ribbon::jitter_test {

const std::filesystem::path sample = RIBBON_SAMPLES "/overhand-hourglass-8x400.toml";

std::string jittered(std::uint64_t seed, double size_m) {
  return jittered_scene(sample, seed, size_m).value();
}

Scene read(const std::string& text) {
  const auto file = temporary_file("jittered.toml");
  EXPECT_TRUE(write_file(file, text).has_value());
  return read_scene(file).value();
}

std::vector<Eigen::Vector2d> points(const Scene& scene) {
  return std::get<DrawnPoints>(scene.curve.drawing).points;
}

TEST(JitteredScene, depends_on_the_seed_alone) {
  EXPECT_EQ(jittered(1, 0.004), jittered(1, 0.004));
  EXPECT_NE(points(read(jittered(1, 0.004))), points(read(jittered(2, 0.004))));
}

TEST(JitteredScene, moves_points_by_up_to_the_size) {
  const auto still = points(read(jittered(1, 0)));
  const auto moved = points(read(jittered(1, 0.004)));
  ASSERT_EQ(still.size(), moved.size());
  double farthest = 0;
  for (std::size_t i = 0; i < still.size(); ++i)
    farthest = std::max(farthest, (moved[i] - still[i]).cwiseAbs().maxCoeff());
  EXPECT_LE(farthest, 4.00001);  // the drawing's unit is the millimetre
  EXPECT_GT(farthest, 3.5);
}

TEST(JitteredScene, spaces_points_evenly_and_keeps_the_ends) {
  const auto still = points(read(jittered(1, 0)));
  ASSERT_GT(still.size(), 100U);
  for (std::size_t i = 1; i < still.size(); ++i)
    EXPECT_NEAR((still[i] - still[i - 1]).norm(), 25, 0.7) << i;
}

TEST(JitteredScene, is_the_same_knot_with_the_same_cloth) {
  const Scene original = read_scene(sample).value();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scene scene = read(jittered(seed, 0.004));
    EXPECT_EQ(scene.name, "overhand-hourglass-8x400-jitter-" + std::to_string(seed));
    EXPECT_EQ(scene.springs.stretch, original.springs.stretch);
    EXPECT_EQ(scene.time.duration_s, original.time.duration_s);
    const auto curve = generate_space_curve(scene.curve, scene.ribbon);
    ASSERT_TRUE(curve.has_value()) << curve.error().sentence();
    EXPECT_EQ(curve->crossings.size(), 3U);
  }
}

TEST(JitteredScene, keeps_what_the_drawing_marks) {
  const auto file = std::filesystem::path(RIBBON_SAMPLES "/gallery/reef.toml");
  const Scene marked = with_marks_found(read_scene(file).value()).value();
  const Scene scene = read(jittered_scene(file, 1, 0.004).value());
  ASSERT_EQ(scene.stages.size(), 2U);
  EXPECT_EQ(scene.stages, marked.stages);
}

TEST(JitteredScene, needs_a_drawing) {
  const auto file = temporary_file("points.toml");
  ASSERT_TRUE(write_file(file, jittered(1, 0)).has_value());
  EXPECT_FALSE(jittered_scene(file, 1, 0.004).has_value());
}

}  // namespace ribbon::jitter_test
