#include "player/measure/value_colors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "recording/sample_recording.h"
#include "result/refusal.h"

namespace ribbon::value_colors_test {

using testing::ElementsAre;

class ValueColorsTest : public TestInFolder {
 protected:
  ValueColors colors(Quantity quantity, const std::optional<ValueRange>& range = std::nullopt,
                     const std::vector<int>& frames = {0, 1, 2, 3, 4, 5, 6}) {
    return ValueColors::create(reader_, quantity, range, frames).value();
  }

  std::vector<float> places(ValueColors& colors, int index) {
    Eigen::Matrix3Xf positions;
    EXPECT_TRUE(reader_.read(index, positions));
    return colors.places(index, positions);
  }

  RecordingReader reader_ = (write_sample_recording(folder_ / "knot.rbn", 7),
                             RecordingReader::open(folder_ / "knot.rbn").value());
};

std::vector<std::string> texts(const Legend& legend) {
  std::vector<std::string> result;
  for (const LegendMark& mark : legend.marks) result.push_back(mark.text);
  return result;
}

TEST_F(ValueColorsTest, the_range_reaches_from_zero_to_the_largest_of_the_frames_asked_for) {
  ValueColors all = colors(Quantity::speed);
  float most = 0;
  for (int index = 0; index < 7; ++index)
    for (const float place : places(all, index)) most = std::max(most, place);
  EXPECT_FLOAT_EQ(most, 1);
  // In the first frame nothing has moved yet.
  EXPECT_THAT(texts(colors(Quantity::speed, std::nullopt, {0}).legend()),
              ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "1"));
}

TEST_F(ValueColorsTest, a_range_that_was_asked_for_is_kept_and_its_ends_say_that_there_is_more) {
  ValueColors strain = colors(Quantity::strain, ValueRange{1, 5});
  const Legend legend = strain.legend();
  EXPECT_EQ(legend.title, "strain, %");
  EXPECT_THAT(texts(legend), ElementsAre("≤ 1", "2", "3", "4", "≥ 5"));
  EXPECT_FLOAT_EQ(legend.marks[1].place, 0.25F);
  EXPECT_THAT(texts(colors(Quantity::strain, ValueRange{0, 10}).legend()),
              ElementsAre("0", "2", "4", "6", "8", "≥ 10"));
}

TEST_F(ValueColorsTest, gaps_reach_to_a_tenth_of_the_width) {
  const Legend legend = colors(Quantity::gap).legend();
  EXPECT_EQ(legend.title, "gap to the next layer, mm");
  EXPECT_THAT(texts(legend), ElementsAre("0", "2", "4", "6", "8", "≥ 10"));
  // What is near is light.
  EXPECT_GT(legend.map.at(0).sum(), legend.map.at(1).sum());
}

TEST_F(ValueColorsTest, contact_tells_what_is_touched_and_how_near_that_is) {
  const Legend legend = colors(Quantity::contact).legend();
  EXPECT_EQ(legend.title, "nearer than 8 mm: touches");  // 0.4 of the 20 mm between columns
  EXPECT_THAT(texts(legend), ElementsAre("obstacle", "nothing", "ribbon"));
  EXPECT_TRUE(legend.fields);
}

TEST(ColorRange, is_two_numbers_with_the_smaller_one_first) {
  EXPECT_EQ(parse_color_range("0:5", Quantity::strain).value(), (ValueRange{0, 5}));
  EXPECT_EQ(parse_color_range("0.5:1e2", Quantity::gap).value(), (ValueRange{0.5, 100}));
  for (const char* text : {"", "5", ":", "1:", ":1", "a:b", "1:2:3", "nan:1", "0:inf", "1 : 2"})
    EXPECT_THAT(parse_color_range(text, Quantity::gap).error().sentence(),
                testing::HasSubstr("is not a range"))
        << text;
  EXPECT_FALSE(parse_color_range("5:5", Quantity::speed));
  EXPECT_FALSE(parse_color_range("-1:5", Quantity::speed));
  EXPECT_FALSE(parse_color_range("1:5", Quantity::contact));
}

}  // namespace ribbon::value_colors_test
