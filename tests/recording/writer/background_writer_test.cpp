#include "recording/writer/background_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "files/files.h"
#include "playback/recording_reader.h"
#include "recording/sample_recording.h"
#include "recording/size_limit.h"
#include "result/refusal.h"

namespace ribbon::background_writer_test {

TEST(BackgroundWriter, it_writes_what_a_writer_in_the_foreground_does) {
  const auto path = temporary_file("background.rbn");
  const auto expected = temporary_file("foreground.rbn");
  const SessionNote note{SessionReason::resumed, "tests", ""};
  {
    auto foreground = RecordingWriter::create(expected, sample_header());
    BackgroundWriter background(RecordingWriter::create(path, sample_header()).value());
    for (int frame = 0; frame < 300; ++frame) {
      ASSERT_TRUE(foreground->append(sample_numbers(frame), sample_positions(frame)).has_value());
      background.append(sample_numbers(frame), sample_positions(frame));
      if (frame % 100 != 99) continue;
      ASSERT_TRUE(foreground->append_checkpoint(frame, "state").has_value());
      background.append_checkpoint(frame, "state");
      ASSERT_TRUE(foreground->append_session(note).has_value());
      background.append_session(note);
    }
    ASSERT_TRUE(foreground->finish(RunEnding::tight).has_value());
    ASSERT_TRUE(background.finish(RunEnding::tight).has_value());
    EXPECT_EQ(background.bytes_written(), std::filesystem::file_size(path));
    const BackgroundFigures figures = background.figures();
    EXPECT_GT(figures.writer.encoding_s, 0);
    EXPECT_GT(figures.writer.writing_s, 0);
    EXPECT_GT(figures.writer.syncing_s, 0);
    EXPECT_GE(figures.longest_queue, 1U);
    EXPECT_LE(figures.longest_queue, 306U);
  }
  EXPECT_TRUE(read_file(path).value() == read_file(expected).value());
}

TEST(BackgroundWriter, what_was_handed_over_is_written_even_if_nobody_finishes) {
  const auto path = temporary_file("abandoned.rbn");
  {
    BackgroundWriter writer(RecordingWriter::create(path, sample_header()).value());
    for (int frame = 0; frame < 50; ++frame)
      writer.append(sample_numbers(frame), sample_positions(frame));
  }
  const auto reader = RecordingReader::open(path);
  EXPECT_EQ(reader->frame_count(), 50);
  EXPECT_FALSE(reader->finished());
}

TEST(BackgroundWriter, what_comes_soon_after_another_is_written_with_it) {
  using namespace std::chrono_literals;
  using Clock = std::chrono::steady_clock;
  BackgroundWriter writer(
      RecordingWriter::create(temporary_file("gathered.rbn"), sample_header()).value());
  const auto wait_for_more_than = [&](std::uint64_t bytes) {
    for (int i = 0; writer.bytes_written() <= bytes && i < 5000; ++i)
      std::this_thread::sleep_for(1ms);
  };
  const std::uint64_t header = writer.bytes_written();
  writer.append(sample_numbers(0), sample_positions(0));
  wait_for_more_than(header);
  std::this_thread::sleep_for(100ms);  // until the thread waits again
  const std::uint64_t before = writer.bytes_written();
  ASSERT_GT(before, header);
  const auto start = Clock::now();
  writer.append(sample_numbers(1), sample_positions(1));
  std::this_thread::sleep_for(20ms);
  writer.append(sample_numbers(2), sample_positions(2));
  const std::uint64_t soon_after = writer.bytes_written();
  if (Clock::now() - start > 90ms) GTEST_SKIP() << "the machine is too busy";
  EXPECT_EQ(soon_after, before);
  wait_for_more_than(before);
  EXPECT_GT(writer.bytes_written(), before);
}

// A busy machine may take as long as frames gather: one quick try of several is enough.
TEST(BackgroundWriter, eight_frames_do_not_wait_for_others) {
  using namespace std::chrono_literals;
  using Clock = std::chrono::steady_clock;
  BackgroundWriter writer(
      RecordingWriter::create(temporary_file("eight.rbn"), sample_header()).value());
  writer.append(sample_numbers(0), sample_positions(0));
  std::this_thread::sleep_for(300ms);  // until it is written and the thread waits again
  auto quickest = Clock::duration::max();
  for (int round = 0; round < 10 && quickest >= 90ms; ++round) {
    const std::uint64_t before = writer.bytes_written();
    const auto start = Clock::now();
    for (int frame = 8 * round + 1; frame <= 8 * round + 8; ++frame)
      writer.append(sample_numbers(frame), sample_positions(frame));
    for (int i = 0; writer.bytes_written() == before && i < 5000; ++i)
      std::this_thread::sleep_for(1ms);
    quickest = std::min(quickest, Clock::now() - start);
    std::this_thread::sleep_for(100ms);
  }
  EXPECT_LT(quickest, 90ms);
}

TEST(BackgroundWriter, what_is_written_reaches_the_disk_while_the_run_goes_on) {
  BackgroundWriter writer(
      RecordingWriter::create(temporary_file("synced.rbn"), sample_header()).value());
  writer.append(sample_numbers(0), sample_positions(0));
  for (int i = 0; writer.figures().writer.syncing_s == 0 && i < 5000; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_GT(writer.figures().writer.syncing_s, 0);
}

TEST(BackgroundWriter, the_first_frame_takes_the_place_of_an_older_file) {
  const auto path = temporary_file("older background.rbn");
  ASSERT_TRUE(write_file(path, "older").has_value());
  BackgroundWriter writer(RecordingWriter::create(path, sample_header()).value());
  writer.append_session({SessionReason::begun, "tests", ""});
  for (int i = 0; writer.figures().writer.syncing_s == 0 && i < 5000; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(read_file(path).value(), "older");
  writer.append(sample_numbers(0), sample_positions(0));
  for (int i = 0; read_file(path).value() == "older" && i < 5000; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(RecordingReader::open(path)->frame_count(), 1) << "while the run goes on";
}

TEST(BackgroundWriter, a_full_disk_is_told_once_and_nothing_is_written_after_it) {
  const auto path = temporary_file("full background.rbn");
  auto target = RecordingWriter::create(path, sample_header()).value();
  ASSERT_TRUE(target.append(sample_numbers(0), sample_positions(0)).has_value());
  const std::uint64_t size = target.bytes_written();
  BackgroundWriter writer(std::move(target));
  EXPECT_TRUE(writer.problem().has_value());
  {
    const SizeLimit limit(size + 20);
    writer.append(sample_numbers(1), sample_positions(1));
    for (int i = 0; writer.problem().has_value() && i < 5000; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_FALSE(writer.problem().has_value());
  writer.append(sample_numbers(2), sample_positions(2));
  EXPECT_EQ(refusal_of(writer.finish(RunEnding::duration)),
            path.string() +
                ": cannot be written (File too large); frame 1 is safe; free some "
                "space and resume the run");
  EXPECT_EQ(std::filesystem::file_size(path), size);
}

}  // namespace ribbon::background_writer_test
