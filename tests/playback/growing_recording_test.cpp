// A reader beside a writer.
#include <gtest/gtest.h>

#include <fstream>

#include "continuation/resume_recording.h"
#include "files/files.h"
#include "playback/recording_reader.h"
#include "playback/sample_frame.h"
#include "recording/sample_recording.h"
#include "recording/writer/background_writer.h"
#include "result/refusal.h"

namespace ribbon::growing_recording_test {

TEST(GrowingRecording, a_reader_sees_each_frame_when_it_is_there) {
  const auto path = temporary_file("growing.rbn");
  auto writer = RecordingWriter::create(path, sample_header()).value();
  auto reader = RecordingReader::open(path).value();
  EXPECT_TRUE(reader.is_being_written());
  for (int frame = 0; frame < 300; ++frame) {
    append_sample_frames(writer, frame, frame + 1);
    ASSERT_TRUE(reader.refresh().has_value());
    ASSERT_EQ(reader.frame_count(), frame + 1);
    expect_sample_frame(reader, frame);
  }
  ASSERT_TRUE(writer.append_checkpoint(5, "state").has_value());
  ASSERT_TRUE(reader.refresh().has_value());
  EXPECT_EQ(reader.checkpoints(), std::vector<std::uint32_t>{299});
  EXPECT_FALSE(reader.finished());
  ASSERT_TRUE(writer.finish(RunEnding::tight).has_value());
  EXPECT_FALSE(reader.is_being_written());
  ASSERT_TRUE(reader.refresh().has_value());
  EXPECT_TRUE(reader.finished());
  EXPECT_EQ(reader.ending(), RunEnding::tight);
  EXPECT_TRUE(reader.damage().empty());
}

TEST(GrowingRecording, asking_who_writes_does_not_keep_a_writer_out) {
  const auto path = temporary_file("asked.rbn");
  write_sample_recording(path, 3);
  const auto reader = RecordingReader::open(path).value();
  EXPECT_FALSE(reader.is_being_written());
  const auto writer = resume_recording(path);
  ASSERT_TRUE(writer.has_value()) << writer.error().sentence();
  EXPECT_TRUE(reader.is_being_written());
}

TEST(GrowingRecording, a_reader_of_a_finished_one_sees_it_extended) {
  const auto path = temporary_file("extended.rbn");
  write_sample_recording(path, 20);
  auto reader = RecordingReader::open(path).value();
  EXPECT_TRUE(reader.finished());
  auto writer = resume_recording(path).value();
  append_sample_frames(writer, 20, 40);
  ASSERT_TRUE(reader.refresh().has_value());
  EXPECT_FALSE(reader.finished());
  EXPECT_EQ(reader.frame_count(), 40);
  for (const int frame : {39, 0, 19, 20}) expect_sample_frame(reader, frame);
  ASSERT_TRUE(writer.finish(RunEnding::duration).has_value());
  ASSERT_TRUE(reader.refresh().has_value());
  EXPECT_TRUE(reader.finished());
  EXPECT_TRUE(reader.damage().empty());
}

// However a write reaches a reader, byte by byte.
TEST(GrowingRecording, half_a_record_is_no_damage) {
  const auto whole = temporary_file("whole growing.rbn");
  write_sample_recording(whole, 4);
  const std::string bytes = read_file(whole).value();
  const auto path = temporary_file("byte by byte.rbn");
  std::ofstream stream(path, std::ios::binary);
  std::size_t begin = 0;
  while (!RecordingReader::open(path)) stream << bytes[begin++] << std::flush;
  auto reader = RecordingReader::open(path).value();
  for (; begin < bytes.size(); ++begin) {
    stream << bytes[begin] << std::flush;
    ASSERT_TRUE(reader.refresh().has_value());
    ASSERT_TRUE(reader.damage().empty()) << begin;
  }
  EXPECT_EQ(reader.frame_count(), 4);
  EXPECT_TRUE(reader.finished());
}

// Garbage behind the last record goes when a writer resumes; a reader must not go on inside it.
TEST(GrowingRecording, a_torn_tail_that_is_replaced_is_forgotten) {
  const auto path = temporary_file("replaced tail.rbn");
  write_sample_recording(path, 5, Ending::killed);
  {
    std::ofstream stream(path, std::ios::binary | std::ios::app);
    stream << std::string(100, 'x');
  }
  auto reader = RecordingReader::open(path).value();
  EXPECT_EQ(reader.damage().size(), 1U);
  auto writer = resume_recording(path).value();
  append_sample_frames(writer, 5, 8);
  ASSERT_TRUE(reader.refresh().has_value());
  EXPECT_TRUE(reader.damage().empty());
  ASSERT_EQ(reader.frame_count(), 8);
  for (int frame = 0; frame < 8; ++frame) expect_sample_frame(reader, frame);
}

TEST(GrowingRecording, one_that_is_recorded_anew_is_read_to_its_own_end) {
  const auto path = temporary_file("anew.rbn");
  write_sample_recording(path, 5);
  auto reader = RecordingReader::open(path).value();
  write_sample_recording(path, 2);
  ASSERT_TRUE(reader.refresh().has_value());
  expect_sample_frame(reader, 4);
  EXPECT_EQ(RecordingReader::open(path)->frame_count(), 2);
}

TEST(GrowingRecording, one_that_is_cut_is_told) {
  const auto path = temporary_file("shorter.rbn");
  write_sample_recording(path, 5);
  auto reader = RecordingReader::open(path).value();
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_EQ(refusal_of(reader.refresh()),
            path.string() +
                ": has become shorter while it was read; it is another recording now: "
                "open it again");
}

TEST(GrowingRecording, a_reader_keeps_up_with_a_writer_in_the_background) {
  const auto path = temporary_file("beside.rbn");
  BackgroundWriter writer(RecordingWriter::create(path, sample_header()).value());
  auto reader = RecordingReader::open(path).value();
  int seen = 0;
  for (int frame = 0; frame < 200; ++frame) {
    writer.append(sample_numbers(frame), sample_positions(frame));
    ASSERT_TRUE(reader.refresh().has_value());
    for (; seen < reader.frame_count(); ++seen) expect_sample_frame(reader, seen);
  }
  ASSERT_TRUE(writer.finish(RunEnding::duration).has_value());
  ASSERT_TRUE(reader.refresh().has_value());
  for (; seen < reader.frame_count(); ++seen) expect_sample_frame(reader, seen);
  EXPECT_EQ(seen, 200);
  EXPECT_TRUE(reader.damage().empty());
}

}  // namespace ribbon::growing_recording_test
