// The drawings of the samples are what their scenes need: an overhand knot round an object that
// stands at the drawing's (0, 0).
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "curve/space_curve.h"

namespace ribbon::samples_test {

class Samples : public testing::TestWithParam<const char*> {
 protected:
  static SpaceCurve curve(double width_m, int samples) {
    CurveScene scene;
    scene.drawing =
        DrawnSvg{{std::filesystem::path(SAMPLES_FOLDER) / (std::string(GetParam()) + ".svg")}, ""};
    scene.clearance_m = 0.01;
    const auto result = generate_space_curve(scene, {.width_m = width_m, .along = samples});
    EXPECT_TRUE(result.has_value()) << result.error().sentence();
    return result.value();
  }
};

INSTANTIATE_TEST_SUITE_P(, Samples,
                         testing::Values("overhand-cylinder", "overhand-hourglass",
                                         "overhand-small-object"));

TEST_P(Samples, is_an_alternating_overhand_knot) {
  const auto crossings = curve(0.09, 400).crossings;
  ASSERT_EQ(crossings.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(crossings[i].sign, -1);  // the first passage rises to the right, over one that falls
    EXPECT_EQ(crossings[i].first_over, i % 2 == 0);
  }
  // 1 2 3 1 2 3, the walk of the trefoil.
  EXPECT_LT(crossings[2].first, crossings[0].second);
  EXPECT_LT(crossings[0].second, crossings[1].second);
  EXPECT_LT(crossings[1].second, crossings[2].second);
}

TEST_P(Samples, has_room_for_narrow_and_wide_ribbons) {
  for (const double width_m : {0.09, 0.18}) {
    const SpaceCurve wide = curve(width_m, 400);
    EXPECT_EQ(wide.points.cols(), 400);
    EXPECT_NEAR(wide.length_m, 4.2, 0.6);
    EXPECT_LE(wide.points.row(1).cwiseAbs().maxCoeff(), (width_m + 0.01) / 2 + 1e-9);
  }
}

TEST_P(Samples, strands_keep_apart) {
  const SpaceCurve drawn = curve(0.09, 400);
  const double step_m = drawn.length_m / 399;
  for (Eigen::Index i = 0; i < 400; ++i)
    for (Eigen::Index j = i + static_cast<Eigen::Index>(0.25 / step_m); j < 400; ++j)
      ASSERT_GT((drawn.points.col(i) - drawn.points.col(j)).norm(), 0.08) << i << " " << j;
}

TEST_P(Samples, goes_once_round_the_object_and_stays_clear_of_it) {
  const SpaceCurve drawn = curve(0.09, 400);
  double turn = 0;
  for (Eigen::Index i = 0; i < 400; ++i) {
    const Eigen::Vector2d here(drawn.points(0, i), drawn.points(2, i));
    EXPECT_GT(here.norm(), 0.3);
    if (i == 0) continue;
    const Eigen::Vector2d before(drawn.points(0, i - 1), drawn.points(2, i - 1));
    turn += std::atan2(before.x() * here.y() - before.y() * here.x(), before.dot(here));
  }
  // From the left end round the front, right, back and left to the right end: a full turn and the
  // angle between the ends.
  EXPECT_GT(std::abs(turn), 2 * 3.14);
}

TEST_P(Samples, is_nowhere_bent_sharply) {
  const SpaceCurve drawn = curve(0.09, 400);
  const double step_m = drawn.length_m / 399;
  for (Eigen::Index i = 1; i < 399; ++i) {
    const Eigen::Vector3d bend =
        drawn.points.col(i - 1) - 2 * drawn.points.col(i) + drawn.points.col(i + 1);
    EXPECT_GT(step_m * step_m / bend.norm(), 0.06) << "radius at sample " << i;
  }
}

}  // namespace ribbon::samples_test
