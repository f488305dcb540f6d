#include "scene/accuracy.h"

#include <gtest/gtest.h>

#include "scene/scene_files.h"

namespace ribbon::accuracy_test {

Scene scene_of(const std::string& word) {
  return read_text("accuracy = '" + word + "'\n" + smallest_scene()).value();
}

void expect_level(const AccuracyLevel& level, const Scene& scene) {
  EXPECT_EQ(scene.time.step_s, level.step_s);
  EXPECT_EQ(scene.time.integrator, std::nullopt);
  EXPECT_EQ(scene.time.usual_integrator, level.integrator);
  EXPECT_EQ(scene.time.tolerance, level.tolerance);
  EXPECT_EQ(scene.strain_correction.strain, level.strain_correction.strain);
  EXPECT_EQ(scene.strain_correction.most_rounds, level.strain_correction.most_rounds);
  EXPECT_EQ(scene.strain_correction.most_sweeps, level.strain_correction.most_sweeps);
}

TEST(Accuracy, a_level_sets_what_the_scene_does_not) {
  for (const AccuracyLevel& level : accuracy_levels)
    expect_level(level, scene_of(std::string(level.word)));
}

TEST(Accuracy, a_scene_that_names_no_level_is_balanced) {
  const AccuracyLevel& balanced = accuracy_levels[1];
  ASSERT_EQ(balanced.word, "balanced");
  expect_level(balanced, Scene{});
  expect_level(balanced, read_text(smallest_scene()).value());
}

TEST(Accuracy, each_level_is_finer_than_the_one_before) {
  for (std::size_t i = 1; i < accuracy_levels.size(); ++i) {
    const AccuracyLevel& coarse = accuracy_levels[i - 1];
    const AccuracyLevel& fine = accuracy_levels[i];
    EXPECT_LT(fine.step_s, coarse.step_s) << fine.word;
    EXPECT_LE(fine.tolerance, coarse.tolerance) << fine.word;
    EXPECT_LE(fine.strain_correction.strain, coarse.strain_correction.strain) << fine.word;
    EXPECT_GE(fine.strain_correction.most_rounds, coarse.strain_correction.most_rounds)
        << fine.word;
    EXPECT_GE(fine.strain_correction.most_sweeps, coarse.strain_correction.most_sweeps)
        << fine.word;
  }
}

TEST(Accuracy, keys_of_the_scene_win_over_the_level) {
  const std::string text = replaced("accuracy = 'draft'\n" + smallest_scene(), "duration",
                                    "integrator = 'implicit'\nstep = 0.0025\nduration");
  const Scene scene = read_text(text).value();
  EXPECT_EQ(scene.time.step_s, 0.0025);
  EXPECT_EQ(scene.time.integrator, IntegrationMethod::implicit);
  EXPECT_EQ(scene.time.tolerance, accuracy_levels[0].tolerance);
}

TEST(Accuracy, no_step_is_longer_than_a_frame) {
  const std::string text = "accuracy = 'draft'\n" + smallest_scene();
  const auto step_s = [&](const std::string& rate) {
    return read_text(text + "[recording]\nframes_per_second = " + rate + "\n").value().time.step_s;
  };
  EXPECT_EQ(step_s("50"), 0.02);
  EXPECT_DOUBLE_EQ(step_s("80"), 0.0125);
}

}  // namespace ribbon::accuracy_test
