#include "player/chart/time_charts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ribbon::time_charts_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

using Frames = std::vector<std::optional<FrameNumbers>>;

Frames fastened(int count) {
  Frames frames;
  for (int k = 0; k < count; ++k)
    frames.push_back(
        FrameNumbers{0.5 * k, 0.01 * k, 2, 3,
                     TightnessNumbers{1 - 0.1F * static_cast<float>(k), 0.25F, 0.5F, 0.125F, 20}});
  return frames;
}

std::vector<std::string> titles(const std::vector<Chart>& charts) {
  std::vector<std::string> result;
  result.reserve(charts.size());
  for (const Chart& chart : charts) result.push_back(chart.title);
  return result;
}

TEST(TimeCharts, there_is_one_for_each_number_of_a_frame) {
  const auto charts = time_charts({}, fastened(3));
  EXPECT_THAT(titles(charts),
              ElementsAre("largest strain, %", "progress, %", "pull of the hands, %",
                          "rows in contact, %", "rope length, widths", "truncated particles, %",
                          "penetrating edges", "recovery iterations"));
  const std::vector<double> last = {2, 80, 50, 12.5, 20, 25, 2, 3};
  for (std::size_t k = 0; k < charts.size(); ++k) {
    ASSERT_THAT(charts[k].lines, SizeIs(1)) << charts[k].title;
    ASSERT_THAT(charts[k].lines[0], SizeIs(3));
    EXPECT_EQ(charts[k].lines[0][2].x(), 1.0);
    EXPECT_NEAR(charts[k].lines[0][2].y(), last[k], 1e-5) << charts[k].title;
  }
}

TEST(TimeCharts, where_nothing_fastens_tightness_has_none) {
  EXPECT_THAT(titles(time_charts({}, {FrameNumbers{}})),
              ElementsAre("largest strain, %", "penetrating edges", "recovery iterations"));
}

TEST(TimeCharts, a_lost_frame_breaks_the_line) {
  Frames frames = fastened(7);
  frames[3].reset();
  frames[4].reset();
  for (const Chart& chart : time_charts({}, frames))
    EXPECT_THAT(chart.lines, ElementsAre(SizeIs(3), SizeIs(2))) << chart.title;
  EXPECT_THAT(time_charts({}, Frames(3))[0].lines, IsEmpty());
}

TEST(TimeCharts, so_does_what_is_no_number) {
  Frames frames = fastened(5);
  frames[2]->worst_strain = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(time_charts({}, frames)[0].lines, ElementsAre(SizeIs(2), SizeIs(2)));
  frames[2]->time_s = std::numeric_limits<double>::infinity();
  EXPECT_THAT(time_charts({}, frames)[1].lines, ElementsAre(SizeIs(2), SizeIs(2)));
}

TEST(TimeCharts, progress_beyond_150_percent_sets_no_scale) {
  for (const Chart& chart : time_charts({}, fastened(3)))
    EXPECT_EQ(std::isinf(chart.most_shown), chart.title != "progress, %") << chart.title;
  EXPECT_EQ(time_charts({}, fastened(3))[1].most_shown, 150);
}

TEST(TimeCharts, a_ribbon_that_does_not_touch_itself_has_no_rope_length) {
  Frames frames = fastened(3);
  frames[0]->tightness->rope_length = 0;
  EXPECT_THAT(time_charts({}, frames)[4].lines, ElementsAre(SizeIs(2)));
}

TEST(TimeCharts, the_limit_of_strain_is_drawn_where_it_is_stated) {
  EXPECT_FALSE(time_charts({}, fastened(2))[0].zone);
  RecordingHeader header;
  header.strain_limit = 0.1;
  const auto zone = time_charts(header, fastened(2))[0].zone;
  ASSERT_TRUE(zone);
  EXPECT_EQ(zone->name, "limit 10 %");
  EXPECT_DOUBLE_EQ(zone->low, 10);
  EXPECT_DOUBLE_EQ(zone->high, 10);
}

}  // namespace ribbon::time_charts_test
