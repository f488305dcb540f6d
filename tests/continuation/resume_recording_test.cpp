// Recordings that go on after their writer has ended, however it ended.
#include "continuation/resume_recording.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "files/failing_disk.h"
#include "files/files.h"
#include "files/flipped.h"
#include "playback/frames_of.h"
#include "playback/recording_reader.h"
#include "recording/sample_recording.h"
#include "recording/size_limit.h"
#include "result/refusal.h"

namespace ribbon::resume_recording_test {

constexpr int frames = 300;  // more than one index record
const SessionNote note{SessionReason::resumed, "tests", ""};

Eigen::Matrix3Xd positions(int frame) {
  Eigen::Matrix3Xd result(3, 6);
  for (int p = 0; p < 6; ++p)
    result.col(p) << 0.1 * p + 1e-5 * frame * frame, std::sin(0.1 * frame * (p + 1)), 0.01 * p;
  return result;
}

void append(RecordingWriter& writer, int begin, int end) {
  for (int frame = begin; frame < end; ++frame) {
    ASSERT_TRUE(writer.append(sample_numbers(frame), positions(frame)).has_value());
    if (frame % 50 == 7) {
      ASSERT_TRUE(writer.append_checkpoint(10UL * frame, "state " + std::to_string(frame)));
    }
  }
}

void put_file(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
}

// What an uninterrupted run records, and the same with one that ends on the way.
class ResumedRecording : public testing::Test {
 protected:
  ResumedRecording() {
    auto whole = RecordingWriter::create(whole_path_, sample_header({3, 2})).value();
    append(whole, 0, frames);
    EXPECT_TRUE(whole.finish(RunEnding::duration).has_value());
    whole_ = read_file(whole_path_).value();
    truth_ = frames_of(whole_path_);
  }

  // As if it had never been interrupted.
  void expect_all_frames(int count = frames) {
    auto reader = RecordingReader::open(path_);
    for (const bool walked : {false, true}) {
      if (walked) reader->check();
      const auto played = frames_of(*reader);
      ASSERT_EQ(played.size(), static_cast<std::size_t>(count));
      EXPECT_EQ(first_difference(played, truth_), -1);
      EXPECT_TRUE(reader->damage().empty());
    }
  }

  std::filesystem::path whole_path_ = temporary_file("whole.rbn");
  std::filesystem::path path_ = temporary_file("resumed.rbn");
  std::string whole_;
  std::vector<PlayedFrame> truth_;
};

TEST_F(ResumedRecording, a_killed_one_goes_on_to_the_same_bytes) {
  // Frame records in the middle, at the first index record, and torn ones.
  for (const std::size_t size :
       {whole_.size() / 7, whole_.size() / 2, whole_.size() * 8 / 10, whole_.size() * 9 / 10}) {
    put_file(path_, whole_.substr(0, size));
    auto writer = resume_recording(path_);
    ASSERT_TRUE(writer.has_value()) << writer.error().sentence();
    const int resumed_at = static_cast<int>(writer->frames_written());
    EXPECT_GT(resumed_at, 0);
    EXPECT_LT(resumed_at, frames);
    append(*writer, resumed_at, frames);
    ASSERT_TRUE(writer->finish(RunEnding::duration).has_value());
    EXPECT_TRUE(read_file(path_).value() == whole_) << size;
  }
}

TEST_F(ResumedRecording, a_finished_one_is_extended_behind_its_footer) {
  {
    auto writer = RecordingWriter::create(path_, sample_header({3, 2})).value();
    append(writer, 0, 130);
    ASSERT_TRUE(writer.finish(RunEnding::duration).has_value());
  }
  const std::string before = read_file(path_).value();
  for (const int end : {131, 200, frames}) {
    auto writer = resume_recording(path_).value();
    const int resumed_at = static_cast<int>(writer.frames_written());
    ASSERT_TRUE(writer.append_session({SessionReason::extended, "tests", "a = 1\n"}).has_value());
    append(writer, resumed_at, end);
    EXPECT_FALSE(RecordingReader::open(path_)->finished()) << "the older footer counts no more";
    ASSERT_TRUE(writer.finish(RunEnding::tight).has_value());
    expect_all_frames(end);
  }
  EXPECT_EQ(read_file(path_).value().substr(0, before.size()), before) << "nothing is rewritten";
  const auto reader = RecordingReader::open(path_);
  EXPECT_EQ(reader->ending(), RunEnding::tight);
  ASSERT_EQ(reader->sessions().size(), 3U);
  EXPECT_EQ(reader->sessions()[1].first_frame, 131U);
  EXPECT_EQ(reader->checkpoints().size(), 6U);
  EXPECT_EQ(reader->read_checkpoint(157)->state, "state 157");
}

// Whatever happens between two frames, in any order.
TEST_F(ResumedRecording, any_life_gives_all_frames) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    std::optional<RecordingWriter> writer =
        RecordingWriter::create(path_, sample_header({3, 2})).value();
    std::size_t sessions = 0;
    for (int frame = 0; frame < frames;) {
      const int end = std::min(frame + static_cast<int>(random() % 90), frames);
      append(*writer, frame, end);
      frame = end;
      if (random() % 2 == 0) {
        ASSERT_TRUE(writer->finish(RunEnding::stopped).has_value());
      }
      writer.reset();
      if (random() % 2 == 0)
        std::ofstream(path_, std::ios::binary | std::ios::app) << std::string(random() % 99, 'x');
      auto resumed = resume_recording(path_);
      ASSERT_TRUE(resumed.has_value()) << resumed.error().sentence();
      writer = std::move(*resumed);
      ASSERT_EQ(writer->frames_written(), static_cast<std::uint32_t>(frame)) << seed;
      ASSERT_TRUE(writer->append_session(note).has_value());
      ++sessions;
    }
    ASSERT_TRUE(writer->finish(RunEnding::tight).has_value());
    expect_all_frames();
    const auto reader = RecordingReader::open(path_);
    EXPECT_EQ(reader->ending(), RunEnding::tight);
    EXPECT_EQ(reader->sessions().size(), sessions);
    EXPECT_EQ(reader->checkpoints(), (std::vector<std::uint32_t>{7, 57, 107, 157, 207, 257}));
  }
}

TEST_F(ResumedRecording, a_torn_tail_is_cut_and_nothing_else) {
  const std::string kept = whole_.substr(0, whole_.size() / 2);
  put_file(path_, kept);
  const std::uint64_t end = resume_recording(path_)->bytes_written();
  for (const std::string& torn :
       {std::string("\xB1REC"), std::string(5000, '\0'), kept.substr(end)}) {
    put_file(path_, kept.substr(0, end) + torn);
    auto writer = resume_recording(path_);
    EXPECT_EQ(writer->bytes_written(), end);
    EXPECT_EQ(std::filesystem::file_size(path_), end);
    append(*writer, static_cast<int>(writer->frames_written()), frames);
    ASSERT_TRUE(writer->finish().has_value());
    expect_all_frames();
  }
}

TEST_F(ResumedRecording, every_prefix_can_go_on) {
  auto writer = RecordingWriter::create(path_, sample_header({3, 2})).value();
  const std::size_t header_end = writer.bytes_written();
  append(writer, 0, 8);
  ASSERT_TRUE(writer.append_session(note).has_value());
  append(writer, 8, 10);
  ASSERT_TRUE(writer.finish().has_value());
  const std::string bytes = read_file(path_).value();
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    put_file(path_, bytes.substr(0, size));
    auto resumed = resume_recording(path_);
    ASSERT_EQ(resumed.has_value(), size >= header_end) << size;
    if (!resumed) continue;
    append(*resumed, static_cast<int>(resumed->frames_written()), 11);
    expect_all_frames(11);
  }
}

// Frames, checkpoints, the index record; the last frame before the end would be cut and come again.
TEST_F(ResumedRecording, after_damage_only_what_was_hit_is_lost) {
  constexpr int killed_at = 272;  // a group begins here
  {
    auto killed = RecordingWriter::create(path_, sample_header({3, 2})).value();
    append(killed, 0, killed_at);
  }
  const std::string bytes = read_file(path_).value();
  for (std::size_t at = 2000; at < bytes.size() - 200; at += 197) {
    put_file(path_, flipped(bytes, at, 0x40));
    auto before = RecordingReader::open(path_);
    auto writer = resume_recording(path_).value();
    ASSERT_EQ(writer.frames_written(), static_cast<std::uint32_t>(killed_at));
    append(writer, killed_at, frames);
    ASSERT_TRUE(writer.finish().has_value());
    const auto played = frames_of(path_);
    ASSERT_EQ(played.size(), truth_.size());
    for (int frame = 0; frame < frames; ++frame) {
      const bool is_there = frame >= killed_at || before->readable(frame);
      ASSERT_EQ(played[frame].positions.cols() > 0, is_there) << at << ": " << frame;
      ASSERT_TRUE(!is_there || played[frame] == truth_[frame]) << at << ": " << frame;
    }
  }
}

TEST_F(ResumedRecording, what_the_disk_does_not_give_today_is_not_cut) {
  const std::string killed = whole_.substr(0, whole_.size() - whole_.size() / 3);
  for (const std::size_t lost : {killed.size() / 4, killed.size() / 2, killed.size() - 5}) {
    put_file(path_, killed);
    {
      const FailingDisk disk(static_cast<off_t>(lost));
      EXPECT_THAT(refusal_of(resume_recording(path_)), HasSubstr("could not be read to its end"))
          << lost;
    }
    EXPECT_EQ(read_file(path_).value(), killed) << lost;
  }
  EXPECT_TRUE(resume_recording(path_));
}

TEST_F(ResumedRecording, only_one_writer_at_a_time) {
  put_file(path_, whole_);
  auto first = resume_recording(path_).value();
  EXPECT_THAT(refusal_of(resume_recording(path_)),
              HasSubstr("is being written by another program"));
  EXPECT_FALSE(RecordingWriter::create(path_, sample_header({3, 2})).has_value());
  EXPECT_EQ(std::filesystem::file_size(path_), whole_.size());
  { const RecordingWriter done = std::move(first); }
  EXPECT_TRUE(resume_recording(path_).has_value()) << "the lock goes with its writer";
}

TEST_F(ResumedRecording, what_is_no_recording_is_left_alone) {
  put_file(path_, "some text that is longer than the head of a record");
  EXPECT_THAT(refusal_of(resume_recording(path_)), HasSubstr("is not a ribbon recording"));
  EXPECT_EQ(read_file(path_).value().size(), 50U);
  EXPECT_FALSE(resume_recording("/no/such.rbn").has_value());
  put_file(path_, whole_);
  std::filesystem::permissions(path_, std::filesystem::perms::owner_read);
  if (::access(path_.c_str(), W_OK) == 0) GTEST_SKIP() << "this user may write anything";
  EXPECT_THAT(refusal_of(resume_recording(path_)), HasSubstr("cannot be written"));
}

TEST_F(ResumedRecording, after_a_full_disk_it_goes_on) {
  std::uint64_t size = 0;
  {
    auto writer = RecordingWriter::create(path_, sample_header({3, 2})).value();
    append(writer, 0, 100);
    size = writer.bytes_written();
    const SizeLimit limit(size + 60);
    EXPECT_FALSE(writer.append(sample_numbers(100), positions(100)).has_value());
  }
  EXPECT_EQ(std::filesystem::file_size(path_), size);
  auto writer = resume_recording(path_).value();
  append(writer, 100, frames);
  ASSERT_TRUE(writer.finish(RunEnding::duration).has_value());
  EXPECT_TRUE(read_file(path_).value() == whole_);
}

// After a power cut a block of the disk may hold what it held before: here another recording's.
TEST_F(ResumedRecording, stale_blocks_of_another_recording_are_never_its_frames) {
  RecordingHeader other = sample_header({3, 2});
  other.scene_name = "other!";
  const auto other_path = temporary_file("other.rbn");
  {
    auto writer = RecordingWriter::create(other_path, other).value();
    append(writer, 0, frames);
    ASSERT_TRUE(writer.finish().has_value());
  }
  const std::string stale = read_file(other_path).value();
  ASSERT_EQ(stale.size(), whole_.size()) << "records must lie at the same offsets";
  constexpr std::size_t block = 4096;
  for (std::size_t at = block; at + block < whole_.size(); at += block) {
    put_file(path_, std::string(whole_).replace(at, block, stale, at, block));
    auto reader = RecordingReader::open(path_).value();
    int lost = 0;
    const auto played = frames_of(reader);
    for (std::size_t frame = 0; frame < played.size(); ++frame)
      if (played[frame].positions.cols() == 0)
        ++lost;
      else
        ASSERT_EQ(played[frame].positions, truth_[frame].positions);
    reader.check();
    EXPECT_FALSE(reader.damage().empty());
    EXPECT_EQ(reader.frame_count(), frames);
    EXPECT_LT(lost, 64);
  }
}

}  // namespace ribbon::resume_recording_test
