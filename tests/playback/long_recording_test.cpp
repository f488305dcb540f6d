// A recording of hours.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "playback/recording_reader.h"
#include "recording/sample_recording.h"
#include "recording/writer/recording_writer.h"

namespace ribbon::long_recording_test {

constexpr int frames = 50'000;

Eigen::Matrix3Xd tiny_positions(int frame) {
  return Eigen::Matrix3Xd::Constant(3, 4, std::sin(0.01 * frame));
}

double seconds_to_open(const std::filesystem::path& path) {
  const auto start = std::chrono::steady_clock::now();
  const auto reader = RecordingReader::open(path);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_TRUE(reader.has_value());
  return elapsed.count();
}

TEST(LongRecording, it_opens_at_once_and_any_frame_is_near) {
  const auto path = temporary_file("long.rbn");
  {
    auto writer = RecordingWriter::create(path, sample_header({2, 2})).value();
    for (int frame = 0; frame < frames; ++frame)
      ASSERT_TRUE(writer.append(sample_numbers(frame), tiny_positions(frame)).has_value());
    ASSERT_TRUE(writer.finish().has_value());
  }
  double best_s = 1;
  for (int i = 0; i < 20; ++i) best_s = std::min(best_s, seconds_to_open(path));
  RecordProperty("open_us", static_cast<int>(1e6 * best_s));
  EXPECT_LE(best_s, 2e-3);
  auto reader = RecordingReader::open(path).value();
  ASSERT_EQ(reader.frame_count(), frames);
  for (int i = 0; i < 500; ++i) {
    const int frame = static_cast<int>(i * 7919L % frames);
    Eigen::Matrix3Xf read;
    ASSERT_TRUE(reader.read(frame, read).has_value());
    EXPECT_LE((read.cast<double>() - tiny_positions(frame)).cwiseAbs().maxCoeff(), 1e-5);
    EXPECT_EQ(reader.numbers(frame), sample_numbers(frame));
  }
  EXPECT_TRUE(reader.finished());
  reader.check();
  EXPECT_EQ(reader.frame_count(), frames);
  EXPECT_TRUE(reader.damage().empty());
}

}  // namespace ribbon::long_recording_test
