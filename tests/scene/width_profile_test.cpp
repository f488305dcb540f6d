#include "scene/width_profile.h"

#include <gtest/gtest.h>

#include "scene/scene.h"

namespace ribbon::width_profile_test {

const WidthProfile tie{{{0, 0.02}, {0.3, 0.03}, {0.4, 0.03}, {0.9, 0.09}, {1, 0.05}}};

TEST(WidthProfile, passes_through_its_points) {
  for (const WidthAt& point : tie.points)
    EXPECT_DOUBLE_EQ(width_at_m(tie, point.share), point.width_m);
}

TEST(WidthProfile, rises_and_falls_only_where_its_points_do) {
  for (std::size_t i = 0; i + 1 < tie.points.size(); ++i) {
    const auto [begin, begin_m] = tie.points[i];
    const auto [end, end_m] = tie.points[i + 1];
    double before_m = begin_m;
    for (int k = 1; k <= 1000; ++k) {
      const double here_m = width_at_m(tie, begin + (end - begin) * k / 1000);
      EXPECT_GE((here_m - before_m) * (end_m >= begin_m ? 1 : -1), -1e-15);
      before_m = here_m;
    }
  }
}

TEST(WidthProfile, has_no_kink_at_its_points) {
  constexpr double step = 1e-6;
  for (const double share : {0.3, 0.4, 0.9}) {
    const double here_m = width_at_m(tie, share);
    const double before = (here_m - width_at_m(tie, share - step)) / step;
    const double after = (width_at_m(tie, share + step) - here_m) / step;
    EXPECT_NEAR(before, after, 1e-5);
  }
}

TEST(WidthProfile, of_two_points_is_straight) {
  const WidthProfile tapered{{{0, 0.02}, {1, 0.1}}};
  EXPECT_DOUBLE_EQ(width_at_m(tapered, 0.25), 0.04);
  EXPECT_DOUBLE_EQ(width_at_m(tapered, 0.5), 0.06);
}

TEST(WidthProfile, gives_each_row_its_width_as_recordings_keep_it) {
  const RibbonScene ribbon{.profile = WidthProfile{{{0, 0.02}, {1, 0.1}}}, .along = 3};
  EXPECT_EQ(row_widths_m(ribbon), (std::vector<double>{0.02F, 0.06F, 0.1F}));
  EXPECT_TRUE(row_widths_m({.width_m = 0.02, .along = 3}).empty());
}

}  // namespace ribbon::width_profile_test
