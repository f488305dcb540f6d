// Every sample scene can be fastened: read, drawn, generated, free at the start and after some
// steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "curve/space_curve.h"
#include "obstacle/obstacle.h"
#include "recorder/run/start.h"
#include "recording/records/checkpoint_record.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/accuracy.h"
#include "simulation/fastening_processor.h"
#include "verification/frame_verifier.h"

namespace ribbon::samples_test {

namespace fs = std::filesystem;

std::vector<fs::path> sample_scenes() {
  std::vector<fs::path> scenes;
  for (const auto& entry : fs::directory_iterator(RIBBON_SAMPLES))
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

class Sample : public testing::TestWithParam<fs::path> {};

TEST_P(Sample, starts_free_of_intersections_and_stays_so) {
  const Scene scene = read_scene(GetParam()).value();
  ASSERT_TRUE(scene.obstacle.has_value());
  const auto curve = generate_space_curve(scene.curve, scene.ribbon);
  ASSERT_TRUE(curve.has_value()) << curve.error().sentence();
  EXPECT_EQ(curve->crossings.size(), 3U);
  const RibbonMesh ribbon = generate_ribbon_mesh(*curve, scene.ribbon, scene.curve.axis);
  const auto obstacle = read_obstacle(*scene.obstacle).value();
  auto fastening = FasteningProcessor::create(scene, ribbon, obstacle).value();
  EXPECT_EQ(fastening.start().kind, StartKind::free);
  for (int step = 0; step < 5; ++step) fastening.step();
  EXPECT_LT(fastening.strain(), 0.1);
  const FrameVerifier verifier(ribbon.size(), obstacle);
  const FrameVerdict verdict = verifier.verify(fastening.positions().cast<float>());
  EXPECT_TRUE(verdict.finite);
  EXPECT_TRUE(verdict.intersections.pairs.empty());
}

TEST_P(Sample, says_its_particles_in_its_name) {
  const Scene scene = read_scene(GetParam()).value();
  EXPECT_EQ(scene.name, GetParam().stem().string());
  EXPECT_TRUE(scene.name.ends_with('-' + std::to_string(scene.ribbon.across) + 'x' +
                                   std::to_string(scene.ribbon.along)));
}

TEST_P(Sample, resists_lengthwise_like_every_other) {
  const Scene scene = read_scene(GetParam()).value();
  for (const double resistance : {scene.springs.stretch, scene.springs.shear, scene.springs.bend})
    EXPECT_DOUBLE_EQ(resistance * scene.ribbon.across / scene.ribbon.along, 0.2);
}

INSTANTIATE_TEST_SUITE_P(All, Sample, testing::ValuesIn(sample_scenes()), [](const auto& sample) {
  std::string name = sample.param.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// Its sash weighs so little that a step has 59 parts. Tight it is 30.1 widths long.
TEST(Samples, hanging_ends_are_drawn_as_tight_in_long_steps) {
  Scene scene = read_scene(fs::path(RIBBON_SAMPLES) / "overhand-hanging-8x400.toml").value();
  set_accuracy(accuracy_levels.front(), scene);
  auto [ribbon, fastening] = find_start(scene, read_obstacle(scene).value()).value();
  while (fastening.time_s() < 2.8) fastening.step();
  EXPECT_LT(fastening.tightness()->rope_length, 31);
}

TEST(Samples, have_checkpoints_of_less_than_190_kB_with_6400_particles) {
  const Scene scene =
      read_scene(fs::path(RIBBON_SAMPLES) / "overhand-hourglass-16x400.toml").value();
  auto [ribbon, fastening] = find_start(scene, read_obstacle(scene).value()).value();
  for (int step = 0; step < 40; ++step) fastening.step();
  EXPECT_LT(checkpoint_payload(1, 1, 40, fastening.state()).size(), 190'000U);
}

TEST(Samples, are_three_overhand_knots_in_two_granularities_one_in_a_third_and_one_hangs) {
  std::vector<std::string> names;
  for (const fs::path& scene : sample_scenes()) names.push_back(scene.stem().string());
  EXPECT_EQ(names, (std::vector<std::string>{
                       "overhand-cylinder-16x400", "overhand-cylinder-8x400",
                       "overhand-hanging-8x400", "overhand-hourglass-16x400",
                       "overhand-hourglass-32x800", "overhand-hourglass-8x400",
                       "overhand-small-object-16x400", "overhand-small-object-8x400"}));
}

}  // namespace ribbon::samples_test
