// What a page shows of a recording, as a browser's worker asks for it.
#include "player/page/shown_recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "files/files.h"
#include "files/flipped.h"
#include "files/temporary_folder.h"
#include "player/render/cloth_pattern.h"
#include "recording/sample_recording.h"

namespace ribbon::shown_recording_test {

class ShownRecordingTest : public ::testing::Test {
 protected:
  ShownRecordingTest() { write_sample_recording(file_, 7); }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "knot.rbn";
};

TEST_F(ShownRecordingTest, describes_what_does_not_change) {
  const auto shown = ShownRecording::open(file_).value();
  const auto told = nlohmann::json::parse(shown.description());
  EXPECT_EQ(told["frames"], 7);
  EXPECT_EQ(told["along"], 40);
  EXPECT_EQ(told["across"], 6);
  EXPECT_EQ(told["damage"].size(), 0U);
  EXPECT_EQ(told["pattern_along"], pattern_along);
  EXPECT_EQ(told["pattern_across"], pattern_across);
  EXPECT_EQ(told["pattern_period"], pattern_period);
  for (int axis = 0; axis < 3; ++axis) EXPECT_LT(told["box_min"][axis], told["box_max"][axis]);
}

TEST_F(ShownRecordingTest, numbers_are_those_of_the_frames) {
  const auto shown = ShownRecording::open(file_).value();
  ASSERT_EQ(shown.numbers().size(), 7U * ShownRecording::numbers_per_frame);
  const auto last = std::span(shown.numbers()).last(ShownRecording::numbers_per_frame);
  EXPECT_EQ(last[ShownRecording::time_s], sample_numbers(6).time_s);
  EXPECT_EQ(last[ShownRecording::strain], sample_numbers(6).worst_strain);
  EXPECT_EQ(last[ShownRecording::readable], 1);
  EXPECT_TRUE(std::isnan(last[ShownRecording::progress])) << "the sample tells none";
}

TEST_F(ShownRecordingTest, grows_with_a_file_that_is_being_written) {
  const std::string whole = read_file(file_).value();
  const auto half = folder_.path() / "half.rbn";
  ASSERT_TRUE(write_file(half, whole.substr(0, whole.size() / 2)));
  auto shown = ShownRecording::open(half).value();
  const std::size_t before = shown.numbers().size();
  ASSERT_LT(before, 7U * ShownRecording::numbers_per_frame);
  std::ofstream(half, std::ios::binary | std::ios::app) << whole.substr(whole.size() / 2);
  ASSERT_TRUE(shown.refresh());
  EXPECT_EQ(shown.numbers().size(), 7U * ShownRecording::numbers_per_frame);
  EXPECT_TRUE(shown.show(6));
}

TEST_F(ShownRecordingTest, particles_are_where_they_were_recorded) {
  auto shown = ShownRecording::open(file_).value();
  ASSERT_TRUE(shown.show(4));
  const Eigen::Matrix3Xd truth = sample_positions(4);
  ASSERT_EQ(shown.particles().size(),
            static_cast<std::size_t>(truth.cols()) * ShownRecording::floats_per_particle);
  const Eigen::Map<const Eigen::MatrixXf> told(shown.particles().data(), 7, truth.cols());
  EXPECT_LT((told.topRows<3>().cast<double>() - truth).cwiseAbs().maxCoeff(), 1e-4);
  for (Eigen::Index p = 0; p < truth.cols(); ++p)
    EXPECT_NEAR(told.col(p).segment<3>(3).norm(), 1, 1e-5);
  EXPECT_GE(told.row(6).minCoeff(), 0);
}

// The page takes less than 1e-6 m for nothing.
TEST_F(ShownRecordingTest, particles_of_a_tiny_scene_are_those_of_its_model) {
  auto expected = ShownRecording::open(file_).value();
  ASSERT_TRUE(expected.show(4));
  constexpr double times = 0x1p-30;
  RecordingHeader header = sample_header();
  for (double* length : {&header.ribbon_length_m, &header.ribbon_width_m, &header.stated_gap_m,
                         &header.max_position_error_m, &header.quantisation_step_m})
    *length *= times;
  header.obstacle->vertices *= static_cast<float>(times);
  std::vector<Eigen::Matrix3Xd> frames(7);
  for (int frame = 0; frame < 7; ++frame) frames[frame] = times * sample_positions(frame);
  std::filesystem::remove(file_);
  write_recording(file_, header, frames);
  auto tiny = ShownRecording::open(file_).value();
  ASSERT_TRUE(tiny.show(4));
  EXPECT_EQ(tiny.particles(), expected.particles());
  EXPECT_EQ(tiny.obstacle(), expected.obstacle());
  const auto box = [](const ShownRecording& shown) {
    return nlohmann::json::parse(shown.description())["box_max"];
  };
  EXPECT_EQ(box(tiny), box(expected));
}

TEST_F(ShownRecordingTest, obstacle_has_three_corners_a_triangle) {
  const auto shown = ShownRecording::open(file_).value();
  EXPECT_EQ(shown.obstacle().size(), 8U * 3 * ShownRecording::floats_per_corner);
}

TEST_F(ShownRecordingTest, of_a_damaged_recording_is_shown_what_can_be_read) {
  const std::string bytes = read_file(file_).value();
  ASSERT_TRUE(write_file(file_, flipped(bytes, bytes.size() / 2)));
  auto shown = ShownRecording::open(file_).value();
  EXPECT_GT(nlohmann::json::parse(shown.description())["damage"].size(), 0U);
  int readable = 0;
  for (int frame = 0; frame < 7; ++frame) {
    const bool is_readable =
        shown.numbers()[ShownRecording::numbers_per_frame * frame + ShownRecording::readable] != 0;
    EXPECT_EQ(shown.show(frame).has_value(), is_readable);
    readable += is_readable ? 1 : 0;
  }
  EXPECT_GT(readable, 0);
  EXPECT_LT(readable, 7);
}

TEST_F(ShownRecordingTest, without_a_frame_it_is_refused) {
  write_sample_recording(file_, 0);
  const auto shown = ShownRecording::open(file_);
  ASSERT_FALSE(shown);
  EXPECT_NE(shown.error().sentence().find("no frame"), std::string::npos);
}

TEST(Pattern, tells_the_sides_apart) {
  const auto texels = cloth_pattern_texels();
  ASSERT_EQ(texels.size(), 2U * 4 * pattern_along * pattern_across);
  const std::size_t middle = 4U * pattern_along * pattern_across / 2;
  EXPECT_GT(texels[middle + 2], texels[middle]) << "a blue front";
  const std::size_t back = middle + texels.size() / 2;
  EXPECT_GT(texels[back], texels[back + 2]) << "a red back";
}

}  // namespace ribbon::shown_recording_test
