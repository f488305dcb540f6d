#include "recording/recording_writer.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <limits>

#include "files/files.h"
#include "playback/recording_reader.h"
#include "recording/sample_recording.h"

namespace ribbon {
namespace {

TEST(RecordingWriter, the_header_is_there_at_once) {
  const auto path = temporary_file("new folder") / "header.rbn";
  const auto writer = RecordingWriter::create(path, sample_header());
  ASSERT_TRUE(writer.has_value()) << writer.error().sentence();
  EXPECT_EQ(std::filesystem::file_size(path), writer->bytes_written());
  const auto reader = RecordingReader::open(path);
  ASSERT_TRUE(reader.has_value()) << reader.error().sentence();
  EXPECT_EQ(reader->header().scene_name, "sample");
  EXPECT_EQ(reader->frame_count(), 0);
  EXPECT_FALSE(reader->finished());
}

TEST(RecordingWriter, each_frame_is_in_the_file_when_append_returns) {
  const auto path = temporary_file("each frame.rbn");
  auto writer = RecordingWriter::create(path, sample_header());
  ASSERT_TRUE(writer.has_value());
  for (int frame = 0; frame < 40; ++frame) {
    ASSERT_TRUE(writer->append(sample_numbers(frame), sample_positions(frame)).has_value());
    EXPECT_EQ(writer->frames_written(), static_cast<std::uint32_t>(frame + 1));
    EXPECT_EQ(std::filesystem::file_size(path), writer->bytes_written());
    EXPECT_EQ(RecordingReader::open(path)->frame_count(), frame + 1);
  }
}

TEST(RecordingWriter, equal_recordings_are_equal_files) {
  write_sample_recording(temporary_file("equal 1.rbn"), 5);
  write_sample_recording(temporary_file("equal 2.rbn"), 5);
  EXPECT_TRUE(read_file(temporary_file("equal 1.rbn")).value() ==
              read_file(temporary_file("equal 2.rbn")).value());
}

TEST(RecordingWriter, a_target_that_cannot_be_written_is_told_before_the_run) {
  const auto writer = RecordingWriter::create("/proc/recording.rbn", sample_header());
  ASSERT_FALSE(writer.has_value());
  EXPECT_NE(writer.error().sentence().find("/proc/recording.rbn: cannot be written ("),
            std::string::npos);
}

TEST(RecordingWriter, a_full_disk_is_told_before_the_run) {
  const auto writer = RecordingWriter::create("/dev/full", sample_header());
  ASSERT_FALSE(writer.has_value());
  EXPECT_EQ(writer.error().sentence(),
            "/dev/full: cannot be written (No space left on device) and the recording holds no "
            "frame; free some space or choose another place");
}

// Files end at `bytes` while one of these lives, as on a full disk.
class SizeLimit {
 public:
  explicit SizeLimit(std::uint64_t bytes) {
    previous_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &previous_);
    const rlimit limit{bytes, previous_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  SizeLimit(const SizeLimit&) = delete;
  SizeLimit& operator=(const SizeLimit&) = delete;
  ~SizeLimit() {
    setrlimit(RLIMIT_FSIZE, &previous_);
    std::signal(SIGXFSZ, previous_handler_);
  }

 private:
  rlimit previous_{};
  void (*previous_handler_)(int) = nullptr;
};

TEST(RecordingWriter, when_the_disk_fills_up_everything_before_is_intact) {
  const auto path = temporary_file("full.rbn");
  auto writer = RecordingWriter::create(path, sample_header());
  ASSERT_TRUE(writer.has_value());
  for (int frame = 0; frame < 3; ++frame)
    ASSERT_TRUE(writer->append(sample_numbers(frame), sample_positions(frame)).has_value());
  Result<void> fourth;
  {
    const SizeLimit limit(writer->bytes_written() + 50);
    fourth = writer->append(sample_numbers(3), sample_positions(3));
  }
  ASSERT_FALSE(fourth.has_value());
  EXPECT_EQ(fourth.error().sentence(),
            path.string() +
                ": cannot be written (File too large) and the recording is complete up to frame "
                "3; free some space or choose another place");
  EXPECT_EQ(std::filesystem::file_size(path), writer->bytes_written())
      << "half a record must not stay behind";
  ASSERT_TRUE(writer->append(sample_numbers(3), sample_positions(3)).has_value())
      << "space was freed";
  ASSERT_TRUE(writer->finish().has_value());
  auto reader = RecordingReader::open(path);
  ASSERT_TRUE(reader.has_value());
  EXPECT_EQ(reader->frame_count(), 4);
  Eigen::Matrix3Xf positions;
  ASSERT_TRUE(reader->read(3, positions).has_value());
  EXPECT_LE((positions.cast<double>() - sample_positions(3)).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(RecordingWriter, a_refused_frame_is_named_and_the_recording_goes_on) {
  const auto path = temporary_file("refused.rbn");
  auto writer = RecordingWriter::create(path, sample_header());
  ASSERT_TRUE(writer.has_value());
  ASSERT_TRUE(writer->append(sample_numbers(0), sample_positions(0)).has_value());
  Eigen::Matrix3Xd positions = sample_positions(1);
  positions(0, 0) = std::numeric_limits<double>::quiet_NaN();
  const auto refused = writer->append(sample_numbers(1), positions);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().place, path.string() + ": frame 2");
  ASSERT_TRUE(writer->append(sample_numbers(1), sample_positions(1)).has_value());
  ASSERT_TRUE(writer->finish().has_value());
  EXPECT_EQ(RecordingReader::open(path)->frame_count(), 2);
}

TEST(RecordingWriter, a_killed_writer_loses_no_appended_frame) {
  const auto path = temporary_file("killed.rbn");
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    auto writer = RecordingWriter::create(path, sample_header());
    for (int frame = 0; frame < 37; ++frame)
      if (!writer->append(sample_numbers(frame), sample_positions(frame))) _exit(1);
    std::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  auto reader = RecordingReader::open(path);
  ASSERT_TRUE(reader.has_value()) << reader.error().sentence();
  EXPECT_EQ(reader->frame_count(), 37);
  EXPECT_FALSE(reader->finished());
  EXPECT_TRUE(reader->damage().empty());
  Eigen::Matrix3Xf positions;
  EXPECT_TRUE(reader->read(36, positions).has_value());
}

TEST(RecordingWriter, a_recording_without_frames_can_be_finished) {
  const auto path = temporary_file("no frames.rbn");
  write_sample_recording(path, 0);
  const auto reader = RecordingReader::open(path);
  ASSERT_TRUE(reader.has_value());
  EXPECT_EQ(reader->frame_count(), 0);
  EXPECT_TRUE(reader->finished());
}

}  // namespace
}  // namespace ribbon
