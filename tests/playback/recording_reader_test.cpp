#include "playback/recording_reader.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "recording/sample_recording.h"

namespace ribbon {
namespace {

std::filesystem::path temporary(const char* name) {
  return std::filesystem::path(testing::TempDir()) / name;
}

double largest_error(const Eigen::Matrix3Xf& read, int frame) {
  return (read.cast<double>() - sample_positions(frame)).cwiseAbs().maxCoeff();
}

TEST(RecordingReader, what_was_recorded_is_read_back) {
  const auto path = temporary("read back.rbn");
  write_sample_recording(path, 40);
  auto reader = RecordingReader::open(path);
  ASSERT_TRUE(reader.has_value()) << reader.error().sentence();
  EXPECT_EQ(reader->frame_count(), 40);
  EXPECT_TRUE(reader->finished());
  EXPECT_TRUE(reader->damage().empty());
  for (int frame = 0; frame < 40; ++frame) {
    EXPECT_EQ(reader->numbers(frame), sample_numbers(frame));
    Eigen::Matrix3Xf positions;
    ASSERT_TRUE(reader->read(frame, positions).has_value());
    EXPECT_LE(largest_error(positions, frame), 1e-5);
  }
}

}  // namespace
}  // namespace ribbon
