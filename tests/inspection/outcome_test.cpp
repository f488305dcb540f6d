#include "inspection/outcome.h"

#include <gtest/gtest.h>

#include "inspection/figures_json.h"
#include "inspection/looped_ribbon.h"
#include "result/refusal.h"

namespace ribbon::outcome_test {

bool embraces(const Pose& pose) {
  return embraces(*object_axis(upright, object), looped(pose));
}

TEST(Embraces, a_loop_round_the_object_does) {
  EXPECT_TRUE(embraces({}));
  EXPECT_TRUE(embraces({.turns = 3}));
  EXPECT_TRUE(embraces({.height_m = 0.29}));
  EXPECT_TRUE(embraces({.height_m = -0.29}));
  EXPECT_TRUE(embraces(*object_axis(upright, object), looped({}).rowwise().reverse()))
      << "from its other end";
}

TEST(Embraces, a_loop_beside_the_object_does_not) {
  EXPECT_FALSE(embraces({.x_m = 0.2}));
}

TEST(Embraces, a_strand_that_runs_past_or_half_round_it_does_not) {
  EXPECT_FALSE(embraces({.turns = 0}));
  EXPECT_FALSE(embraces({.turns = 0.5}));
}

TEST(Embraces, a_loop_beyond_an_end_of_the_object_does_not) {
  EXPECT_FALSE(embraces({.height_m = 0.31}));
  EXPECT_FALSE(embraces({.height_m = -0.31}));
}

TEST(Embraces, a_slanted_loop_counts_where_the_axis_passes_it) {
  EXPECT_TRUE(embraces({.height_m = 0.26, .slant = 2, .x_m = 0.02}));
  // Its middle, above x = 0.05, is level with the object, but the axis passes it above.
  EXPECT_FALSE(embraces({.height_m = 0.26, .slant = -2, .x_m = 0.05}));
}

std::optional<double> distance_of_knot_m(const Pose& pose) {
  const RecordingHeader header = header_with_post();
  return knot_distance_m(header, looped_ribbon(header, pose).cast<float>(), object);
}

TEST(KnotDistance, is_that_of_the_rows_that_are_nearest_to_each_other) {
  // At z = 0.07, x = 0 of the loop; 0.06 where the ribbon's inner selvage is.
  EXPECT_NEAR(distance_of_knot_m({}).value(), 0.01, 0.001);
  EXPECT_NEAR(distance_of_knot_m({.x_m = 0.3}).value(), 0.21, 0.01);
}

TEST(KnotDistance, there_is_none_without_rows_that_come_near) {
  EXPECT_FALSE(distance_of_knot_m({.turns = 0.5}).has_value());
}

std::optional<Outcome> outcome_of(const RecordingHeader& header, const std::vector<Pose>& poses) {
  auto reader = RecordingReader::open(record_loops(header, poses));
  return outcome(*reader);
}

TEST(OutcomeOfARecording, a_loop_that_stays_embraces_the_object) {
  const auto outcome = outcome_of(header_with_post(), {{}, {.height_m = 0.1}}).value();
  EXPECT_TRUE(outcome.embraces_object);
  EXPECT_FALSE(outcome.slipped_off.has_value());
  EXPECT_EQ(outcome_text({.embraces_object = true, .knot_distance_m = 0.0000123}),
            "round the object, the knot 0.0123 mm from it");
  EXPECT_EQ(outcome_text(outcome), "round the object, the knot 10 mm from it");
}

TEST(OutcomeOfARecording, a_loop_that_slips_off_is_told_with_its_moment) {
  std::vector<Pose> poses(40);
  for (int k = 0; k < 40; ++k) poses[k].height_m = 0.02 * k;  // beyond the end from frame 17 on
  const auto outcome = outcome_of(header_with_post(), poses);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_FALSE(outcome->embraces_object);
  ASSERT_TRUE(outcome->slipped_off.has_value());
  EXPECT_EQ(outcome->slipped_off->frame, 16);
  EXPECT_EQ(outcome->slipped_off->time_s, 0.3);
  EXPECT_EQ(outcome_text(*outcome).substr(0, 33), "slipped off the object at 0.30 s,");
  EXPECT_THAT(outcome_json(outcome).text(), HasSubstr("\"frame\": 16"));
}

TEST(OutcomeOfARecording, a_knot_beside_its_post_is_not_round_it) {
  const auto outcome = outcome_of(header_with_post(), {{.x_m = 0.3}, {.x_m = 0.3}}).value();
  EXPECT_FALSE(outcome.embraces_object);
  EXPECT_FALSE(outcome.slipped_off.has_value());
  EXPECT_EQ(outcome_text(outcome).substr(0, 31), "not round the object, the knot ");
}

TEST(OutcomeOfARecording, there_is_none_without_an_object) {
  RecordingHeader header = header_with_post();
  header.obstacle.reset();
  EXPECT_FALSE(outcome_of(header, {{}, {}}).has_value());
  EXPECT_EQ(outcome_json(std::nullopt).text(), "null\n");
}

}  // namespace ribbon::outcome_test
