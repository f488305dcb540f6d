#include "playback/recording_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "files/files.h"
#include "playback/frames_of.h"
#include "playback/sample_frame.h"
#include "recording/records/record_head.h"
#include "recording/sample_recording.h"
#include "result/refusal.h"

namespace ribbon::recording_reader_test {

TEST(RecordingReader, what_was_recorded_is_read_back) {
  const auto path = temporary_file("read back.rbn");
  write_sample_recording(path, 40);
  auto reader = RecordingReader::open(path);
  ASSERT_TRUE(reader.has_value()) << reader.error().sentence();
  EXPECT_EQ(reader->header().scene_text, sample_header().scene_text);
  EXPECT_EQ(reader->frame_count(), 40);
  EXPECT_TRUE(reader->finished());
  EXPECT_TRUE(reader->damage().empty());
  EXPECT_EQ(reader->file_bytes(), std::filesystem::file_size(path));
  for (int frame = 0; frame < 40; ++frame) {
    EXPECT_TRUE(reader->readable(frame));
    expect_sample_frame(*reader, frame);
  }
}

TEST(RecordingReader, jumping_to_a_frame_equals_playing_to_it) {
  constexpr int frames = 70;
  const auto path = temporary_file("jump.rbn");
  write_sample_recording(path, frames);
  auto player = RecordingReader::open(path);
  auto jumper = RecordingReader::open(path);
  ASSERT_TRUE(player.has_value() && jumper.has_value());
  const std::vector<PlayedFrame> played = frames_of(*player);
  for (int step = 0; step < 3 * frames; ++step) {
    const int frame = (step * 29 + step / 7) % frames;  // back and forth, some of them twice
    Eigen::Matrix3Xf jumped;
    ASSERT_TRUE(jumper->read(frame, jumped).has_value());
    ASSERT_EQ(jumped, played[frame].positions) << "frame " << frame;
    ASSERT_TRUE(jumper->read(frame, jumped).has_value());
    ASSERT_EQ(jumped, played[frame].positions) << "frame " << frame << " again";
  }
}

TEST(RecordingReader, a_killed_recording_reads_like_a_finished_one) {
  write_sample_recording(temporary_file("finished.rbn"), 35);
  write_sample_recording(temporary_file("killed.rbn"), 35, Ending::killed);
  auto finished = RecordingReader::open(temporary_file("finished.rbn"));
  auto killed = RecordingReader::open(temporary_file("killed.rbn"));
  ASSERT_TRUE(finished.has_value() && killed.has_value());
  EXPECT_FALSE(killed->finished());
  EXPECT_TRUE(killed->damage().empty());
  EXPECT_EQ(killed->frame_count(), 35);
  EXPECT_EQ(frames_of(*killed), frames_of(*finished));
}

TEST(RecordingReader, a_missing_file_is_named) {
  EXPECT_EQ(refusal_of(RecordingReader::open("/no/such.rbn")),
            "/no/such.rbn: cannot be opened (No such file or directory); check the name and the "
            "permissions");
}

TEST(RecordingReader, what_is_no_recording_is_refused) {
  const auto path = temporary_file("text.rbn");
  for (const char* bytes : {"x", "some text that is longer than the head of a record"}) {
    ASSERT_TRUE(write_file(path, bytes).has_value());
    EXPECT_THAT(refusal_of(RecordingReader::open(path)), HasSubstr("is not a ribbon recording"));
  }
  for (const std::string& no_file : {testing::TempDir(), std::string("/dev/null")})
    EXPECT_EQ(refusal_of(RecordingReader::open(no_file)),
              no_file + ": is not a file; name a recording");
}

// As a recorder leaves it that is killed at once.
TEST(RecordingReader, what_ends_before_its_first_frame_says_so) {
  const auto path = temporary_file("cut.rbn");
  std::filesystem::remove(path);
  write_sample_recording(path, 1, Ending::killed);
  const std::string whole = read_file(path).value();
  const std::size_t header_end = 8 + 24 + parse_record_head(whole.substr(8, 24))->payload_bytes;
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{3}, std::size_t{8}, std::size_t{12},
                                  std::size_t{100}, header_end - 1}) {
    ASSERT_TRUE(write_file(path, whole.substr(0, bytes)).has_value());
    EXPECT_THAT(refusal_of(RecordingReader::open(path)),
                AllOf(HasSubstr("ends before its first frame"), HasSubstr("--force")))
        << bytes;
  }
  ASSERT_TRUE(write_file(path, whole.substr(0, header_end)).has_value());
  EXPECT_EQ(RecordingReader::open(path).value().frame_count(), 0);
}

}  // namespace ribbon::recording_reader_test
