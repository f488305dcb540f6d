// Whatever happens to a file: no crash, no wrong frame passed as right, and everything that is
// still there is read.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "files/failing_disk.h"
#include "files/files.h"
#include "files/flipped.h"
#include "playback/recording_reader.h"
#include "recording/codec/position_encoder.h"
#include "recording/coding/bytes.h"
#include "recording/coding/checksum.h"
#include "recording/records/directory_record.h"
#include "recording/records/header_record.h"
#include "recording/records/record_head.h"
#include "recording/records/session_record.h"
#include "recording/sample_recording.h"
#include "recording/writer/recording_writer.h"
#include "result/refusal.h"

namespace ribbon::damaged_recording_test {

constexpr int second_group = group_frames;
constexpr int frames = second_group + 4;

// A recording as small as possible, and what its undamaged frames are.
class DamagedRecording : public testing::Test {
 protected:
  DamagedRecording() {
    auto writer = RecordingWriter::create(path_, sample_header({3, 2}));
    header_end_ = writer->bytes_written();
    for (int frame = 0; frame < frames; ++frame) {
      if (frame == 10) {
        EXPECT_TRUE(writer->append_session(session_.note).has_value());
      }
      begin_.push_back(writer->bytes_written());
      EXPECT_TRUE(writer->append(sample_numbers(frame), positions(frame)).has_value());
      end_.push_back(writer->bytes_written());
      if (frame == 7) {
        EXPECT_TRUE(writer->append_checkpoint(70, checkpoint_.state).has_value());
      }
    }
    begin_.push_back(writer->bytes_written());
    EXPECT_TRUE(writer->finish().has_value());
    finished_ = read_file(path_).value();
    killed_ = finished_.substr(0, begin_.back());
    auto reader = RecordingReader::open(path_);
    truth_.resize(frames);
    for (int frame = 0; frame < frames; ++frame)
      EXPECT_TRUE(reader->read(frame, truth_[frame]).has_value());
  }

  static Eigen::Matrix3Xd positions(int frame) {
    Eigen::Matrix3Xd result(3, 6);
    for (int p = 0; p < 6; ++p)
      result.col(p) << 0.1 * p + 0.0003 * frame * frame, std::sin(0.1 * frame * (p + 1)), 0.01 * p;
    return result;
  }

  Result<RecordingReader> open(const std::string& bytes) {
    // A new file each time: rewriting an old one waits for the disk, thousands of times.
    std::filesystem::remove(path_);
    std::ofstream(path_, std::ios::binary) << bytes;
    return RecordingReader::open(path_);
  }

  // Reads all frames; those that can be read must be what they were. Returns the others.
  std::vector<int> lost_frames(RecordingReader& reader) const {
    std::vector<int> lost;
    for (int frame = 0; frame < reader.frame_count(); ++frame) {
      Eigen::Matrix3Xf read;
      const bool done = reader.read(frame, read).has_value();
      EXPECT_EQ(done, reader.readable(frame)) << "after the attempt both must agree";
      if (!done) {
        lost.push_back(frame);
        continue;
      }
      EXPECT_EQ(read, truth_.at(frame)) << "frame " << frame;
      EXPECT_EQ(reader.numbers(frame), sample_numbers(frame));
    }
    return lost;
  }

  // How many frames lie whole before this byte.
  [[nodiscard]] int frames_before(std::size_t byte) const {
    return static_cast<int>(std::upper_bound(end_.begin(), end_.end(), byte) - end_.begin());
  }

  // The frame whose record holds this byte; -1 where that is no frame's.
  [[nodiscard]] int frame_at(std::size_t byte) const {
    const int frame = frames_before(byte);
    return frame < frames && byte >= begin_[frame] ? frame : -1;
  }

  // Checkpoints and sessions are there as they were or not at all. How many are not?
  [[nodiscard]] int lost_others(const RecordingReader& reader) const {
    int lost = 2;
    for (const std::uint32_t frame : reader.checkpoints()) {
      const auto read = reader.read_checkpoint(frame);
      if (!read) continue;
      EXPECT_EQ(*read, checkpoint_);
      --lost;
    }
    for (const Session& session : reader.sessions()) {
      EXPECT_EQ(session, session_);
      --lost;
    }
    return lost;
  }

  // What is lost with a frame: it and those behind it up to the next key frame.
  static std::vector<int> group_from(int frame) {
    std::vector<int> lost;
    if (frame < 0) return lost;
    for (int next = frame; next < (frame < second_group ? second_group : frames); ++next)
      lost.push_back(next);
    return lost;
  }

  std::filesystem::path path_ = temporary_file("damaged.rbn");
  std::size_t header_end_ = 0;
  std::vector<std::uint64_t> begin_;  // of each frame's record, and the end of the last
  std::vector<std::uint64_t> end_;    // of each frame's record
  const Checkpoint checkpoint_{7, 70, "the state after frame 7"};
  const Session session_{10, {SessionReason::resumed, "tests", "a = 1\n"}};
  std::string finished_;
  std::string killed_;
  std::vector<Eigen::Matrix3Xf> truth_;
};

TEST_F(DamagedRecording, what_the_disk_cannot_read_is_named_wherever_it_begins) {
  ASSERT_TRUE(write_file(path_, killed_));
  for (const std::size_t lost : {begin_[3], begin_[3] + 5, begin_[3] + record_head_bytes + 2}) {
    const FailingDisk disk(static_cast<off_t>(lost));
    auto reader = RecordingReader::open(path_);
    ASSERT_TRUE(reader);
    reader->check();
    EXPECT_TRUE(reader->readable(2)) << lost;
    for (int frame = 3; frame < reader->frame_count(); ++frame)
      EXPECT_FALSE(reader->readable(frame)) << lost;
    ASSERT_EQ(reader->damage().size(), 1U) << lost;
    EXPECT_EQ(reader->damage()[0].reason, "the disk cannot read it") << lost;
    EXPECT_EQ(reader->damage()[0].byte, begin_[3]) << lost;
  }
}

TEST_F(DamagedRecording, a_cut_tail_is_a_normal_end) {
  for (std::size_t size = 0; size < finished_.size(); ++size) {
    auto reader = open(finished_.substr(0, size));
    ASSERT_EQ(reader.has_value(), size >= header_end_) << "cut at " << size;
    if (!reader) continue;
    ASSERT_EQ(reader->frame_count(), frames_before(size)) << "cut at " << size;
    ASSERT_TRUE(reader->damage().empty()) << "cut at " << size;
    ASSERT_TRUE(lost_frames(*reader).empty()) << "cut at " << size;
  }
}

TEST_F(DamagedRecording, every_flipped_byte_of_a_finished_file_costs_at_most_its_group) {
  for (std::size_t byte = 0; byte < finished_.size(); ++byte) {
    auto reader = open(flipped(finished_, byte, byte % 2 == 0 ? 0x01 : 0xC3));
    if (byte >= file_signature.size() && byte < header_end_) {
      ASSERT_FALSE(reader.has_value()) << "byte " << byte;
      continue;
    }
    ASSERT_TRUE(reader.has_value()) << "byte " << byte;
    ASSERT_EQ(reader->frame_count(), frames) << "byte " << byte;
    const int frame = frame_at(byte);
    const bool in_other = byte >= header_end_ && byte < begin_.back() && frame < 0;
    ASSERT_EQ(lost_frames(*reader), group_from(frame)) << "byte " << byte;
    ASSERT_EQ(lost_others(*reader), in_other ? 1 : 0) << "byte " << byte;
    reader->check();
    ASSERT_EQ(lost_frames(*reader), group_from(frame)) << "byte " << byte;
    ASSERT_EQ(lost_others(*reader), in_other ? 1 : 0) << "byte " << byte;
    ASSERT_FALSE(reader->damage().empty()) << "byte " << byte;
    ASSERT_TRUE(reader->finished()) << "byte " << byte;
  }
}

TEST_F(DamagedRecording, every_flipped_byte_of_a_killed_file_costs_at_most_its_group) {
  for (std::size_t byte = header_end_; byte < killed_.size(); ++byte) {
    auto reader = open(flipped(killed_, byte, 0x20));
    ASSERT_TRUE(reader.has_value()) << "byte " << byte;
    std::vector<int> expected = group_from(frame_at(byte));
    const bool last_head =
        byte >= begin_[frames - 1] && byte < begin_[frames - 1] + record_head_bytes;
    if (last_head) expected.clear();  // nobody knows that it was a frame
    ASSERT_EQ(reader->frame_count(), last_head ? frames - 1 : frames) << "byte " << byte;
    ASSERT_EQ(lost_frames(*reader), expected) << "byte " << byte;
    ASSERT_FALSE(reader->damage().empty()) << "byte " << byte;
    ASSERT_FALSE(reader->finished());
  }
}

TEST_F(DamagedRecording, damage_is_reported_where_it_is) {
  auto reader = open(flipped(killed_, begin_[5] + record_head_bytes + 3)).value();
  ASSERT_EQ(reader.damage().size(), 1U);
  EXPECT_EQ(reader.damage()[0].byte, begin_[5]);
  EXPECT_EQ(reader.damage()[0].length, begin_[6] - begin_[5]);
  EXPECT_FALSE(reader.numbers(5).has_value());
  EXPECT_EQ(reader.numbers(6), sample_numbers(6)) << "numbers need no other frame";
  EXPECT_FALSE(reader.readable(6));
  EXPECT_TRUE(reader.readable(second_group));
}

TEST_F(DamagedRecording, a_check_finds_what_nobody_has_read_yet) {
  auto reader = open(flipped(finished_, begin_[5] + record_head_bytes + 3)).value();
  EXPECT_TRUE(reader.readable(6)) << "the index is whole";
  reader.check();
  EXPECT_FALSE(reader.readable(6));
  EXPECT_EQ(reader.damage().size(), 1U);
  reader.check();
  EXPECT_EQ(reader.damage().size(), 1U) << "not twice";
  EXPECT_TRUE(reader.finished());
}

TEST_F(DamagedRecording, a_hole_in_the_file_loses_the_frames_within) {
  // Cut within two heads that begin alike, the pieces make one that is right; within two payloads
  // they do not.
  for (const std::size_t inside : {std::size_t{10}, record_head_bytes + 20}) {
    std::string bytes = killed_;
    const std::size_t hole = begin_[4] + inside;
    bytes.erase(hole, begin_[8] + inside - hole);
    auto reader = open(bytes).value();
    const std::vector<int> lost = lost_frames(reader);
    for (const int frame : {4, 5, 6, 7})
      EXPECT_NE(std::find(lost.begin(), lost.end(), frame), lost.end()) << frame;
    EXPECT_TRUE(reader.readable(3));
  }
}

TEST_F(DamagedRecording, zeroed_blocks_keep_the_frames_numbers) {
  std::string bytes = killed_;
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(begin_[10]),
            bytes.begin() + static_cast<std::ptrdiff_t>(begin_[13]), '\0');
  auto reader = open(bytes).value();
  EXPECT_EQ(reader.frame_count(), frames);
  EXPECT_EQ(lost_frames(reader), group_from(10));
  ASSERT_EQ(reader.damage().size(), 1U);
  EXPECT_EQ(reader.damage()[0].length, begin_[13] - begin_[10]);
}

TEST_F(DamagedRecording, a_tail_of_zeros_is_damage_and_costs_nothing) {
  auto reader = open(killed_ + std::string(5000, '\0')).value();
  EXPECT_EQ(reader.frame_count(), frames);
  EXPECT_TRUE(lost_frames(reader).empty());
  ASSERT_EQ(reader.damage().size(), 1U);
  EXPECT_EQ(reader.damage()[0].length, 5000U);
}

TEST_F(DamagedRecording, bytes_behind_the_footer_cost_nothing) {
  auto reader = open(finished_ + "tail").value();
  EXPECT_EQ(reader.frame_count(), frames);
  EXPECT_TRUE(reader.finished());
  EXPECT_TRUE(lost_frames(reader).empty());
}

// What stands there may be a frame, and the last one; it is counted once.
TEST_F(DamagedRecording, a_damaged_tail_that_grows_is_no_more_frames) {
  auto reader = open(flipped(killed_, begin_[frames - 1] + record_head_bytes + 3)).value();
  EXPECT_EQ(reader.frame_count(), frames);
  std::ofstream(path_, std::ios::app | std::ios::binary) << record_magic;
  ASSERT_TRUE(reader.refresh().has_value());
  EXPECT_EQ(reader.frame_count(), frames);
}

TEST_F(DamagedRecording, a_run_that_was_taken_up_and_stopped_at_once_has_no_end) {
  auto reader = open(finished_).value();
  EXPECT_TRUE(reader.finished());
  std::ofstream(path_, std::ios::app | std::ios::binary) << make_record(
      RecordType::session, session_payload(reader.recording_id(), {frames, session_.note}));
  ASSERT_TRUE(reader.refresh().has_value());
  EXPECT_FALSE(reader.finished());
  EXPECT_FALSE(RecordingReader::open(path_)->finished());
}

TEST_F(DamagedRecording, an_unknown_record_is_skipped) {
  std::string bytes = killed_;
  bytes.insert(begin_[7], make_record(static_cast<RecordType>(4711), "what later versions know"));
  auto reader = open(bytes).value();
  EXPECT_EQ(reader.frame_count(), frames);
  EXPECT_TRUE(reader.damage().empty());
  EXPECT_TRUE(lost_frames(reader).empty());
}

TEST_F(DamagedRecording, an_index_that_points_elsewhere_is_found_out) {
  std::string bytes = killed_;
  const std::string moved = make_record(static_cast<RecordType>(4711), "in between");
  bytes.insert(begin_[7], moved);  // the index below does not know of it
  auto reader = open(bytes + finished_.substr(begin_.back())).value();
  EXPECT_TRUE(lost_frames(reader).empty());
  EXPECT_TRUE(reader.damage().empty()) << "nothing is damaged but the index";
}

TEST_F(DamagedRecording, frames_of_another_recording_do_not_belong) {
  RecordingHeader other = sample_header({3, 2});
  other.scene_name = "other";
  const std::string header =
      std::string(file_signature) + make_record(RecordType::header, header_payload(other));
  auto reader = open(header + killed_.substr(header_end_)).value();
  EXPECT_EQ(reader.frame_count(), 0);
  EXPECT_FALSE(reader.damage().empty());
}

// As a disk does that writes a block twice: what comes again earlier lies before its reference.
TEST_F(DamagedRecording, records_that_come_again_earlier_are_read_where_they_were) {
  const std::string again = killed_.substr(begin_[5], end_[6] - begin_[5]);
  auto reader = open(killed_.substr(0, begin_[1]) + again + killed_.substr(begin_[1])).value();
  EXPECT_EQ(reader.frame_count(), frames);
  EXPECT_TRUE(lost_frames(reader).empty());
}

TEST_F(DamagedRecording, a_frame_number_that_the_file_cannot_hold_is_refused) {
  std::string bytes = killed_.substr(0, begin_[1]);
  std::string payload =
      killed_.substr(begin_[1] + record_head_bytes, begin_[2] - begin_[1] - record_head_bytes);
  payload.replace(4, 4, "\xF0\xFF\xFF\xFF");
  auto reader = open(bytes + make_record(RecordType::frame, payload)).value();
  EXPECT_EQ(reader.frame_count(), 1);
  EXPECT_EQ(reader.damage().size(), 1U);
}

TEST_F(DamagedRecording, a_length_that_the_file_cannot_hold_is_a_cut_tail) {
  std::string head(record_magic);
  put<std::uint32_t>(head, 2);
  put<std::uint64_t>(head, 0xFFFFFFFFFFFFFFFF);
  put<std::uint32_t>(head, 0);
  put<std::uint32_t>(head, checksum(head));
  auto reader = open(killed_ + head).value();
  EXPECT_EQ(reader.frame_count(), frames);
  EXPECT_TRUE(reader.damage().empty());
  auto hidden = open(killed_.substr(0, begin_[5]) + head + killed_.substr(begin_[5])).value();
  EXPECT_EQ(hidden.frame_count(), frames) << "frames behind it are found";
  EXPECT_EQ(hidden.damage().size(), 1U);
}

TEST_F(DamagedRecording, geometry_that_is_not_valid_makes_its_group_unreadable) {
  std::string payload =
      killed_.substr(begin_[3] + record_head_bytes, begin_[4] - begin_[3] - record_head_bytes);
  const std::size_t geometry_at = static_cast<unsigned char>(payload[8]);
  payload.replace(geometry_at, payload.size() - geometry_at, "no zstd frame");
  std::string bytes = killed_;
  bytes.replace(begin_[3], begin_[4] - begin_[3], make_record(RecordType::frame, payload));
  auto reader = open(bytes).value();
  Eigen::Matrix3Xf read;
  for (int frame = 3; frame < second_group; ++frame)
    EXPECT_FALSE(reader.read(frame, read).has_value());
  ASSERT_TRUE(reader.read(2, read).has_value());
  EXPECT_EQ(read, truth_[2]);
  ASSERT_TRUE(reader.read(second_group, read).has_value());
  EXPECT_EQ(read, truth_[second_group]);
}

// Nothing that a writer of ours writes, and whole by all checksums.
TEST_F(DamagedRecording, frames_that_refer_to_later_ones_are_not_readable) {
  auto writer = RecordingWriter::create(path_, sample_header({3, 2}));
  const std::vector<std::optional<std::uint32_t>> references = {{}, 2, 1, 2};
  for (std::uint32_t frame = 0; frame < references.size(); ++frame) {
    const FrameRecord record{.frame = frame, .reference = references[frame]};
    ASSERT_TRUE(writer->append_encoded(record).has_value());
  }
  ASSERT_TRUE(writer->finish().has_value());
  auto reader = RecordingReader::open(path_);
  ASSERT_EQ(reader->frame_count(), 4);
  EXPECT_TRUE(reader->readable(0));
  for (int frame = 1; frame < 4; ++frame) EXPECT_FALSE(reader->readable(frame)) << frame;
}

// So many frames in two index records. All but the key frames need the one before.
class LongChain : public DamagedRecording {
 protected:
  static constexpr std::uint32_t count = 258;

  void write_chain(const std::function<bool(std::uint32_t)>& is_key_frame) {
    const RecordingHeader header = sample_header({3, 2});
    PositionEncoder encoder(codec_parameters(header), header.max_position_error_m);
    auto writer = RecordingWriter::create(path_, header);
    QuantisedFrame last;
    for (std::uint32_t frame = 0; frame < count; ++frame) {
      before_.push_back(writer->bytes_written());
      FrameRecord record{.frame = frame, .numbers = sample_numbers(static_cast<int>(frame))};
      if (!is_key_frame(frame)) record.reference = frame - 1;
      auto encoded =
          encoder.encode(positions(static_cast<int>(frame)), record.reference ? &last : nullptr);
      record.encoding = encoded->encoding;
      record.geometry = encoded->geometry;
      EXPECT_TRUE(writer->append_encoded(record).has_value());
      last = std::move(encoded->frame);
    }
    before_.push_back(writer->bytes_written());
    EXPECT_TRUE(writer->finish().has_value());
  }

  // Reads a frame as nearly as it was encoded.
  static bool is_read(RecordingReader& reader, int frame) {
    Eigen::Matrix3Xf read;
    return reader.read(frame, read).has_value() &&
           (read.cast<double>() - positions(frame)).cwiseAbs().maxCoeff() <= 1e-5;
  }

  std::vector<std::uint64_t> before_;  // what was written before each frame, and before the end
};

// Nothing that a writer of ours writes.
TEST_F(LongChain, a_frame_may_need_256_others_and_no_more) {
  write_chain([](std::uint32_t frame) { return frame == 0; });
  auto reader = RecordingReader::open(path_).value();
  EXPECT_TRUE(is_read(reader, 256));
  EXPECT_FALSE(RecordingReader::open(path_)->readable(257));
  EXPECT_FALSE(is_read(reader, 257)) << "though the one before it is at hand";
  EXPECT_TRUE(is_read(reader, 0));
}

// Frame 256 needs those before it, which the damaged index tells of.
class DamagedFirstIndex : public LongChain {
 protected:
  DamagedFirstIndex() {
    write_chain([](std::uint32_t frame) { return frame == 0 || frame % 16 == 1; });
    damaged_ = flipped(read_file(path_).value(), first_index() + record_head_bytes + 20);
  }
  [[nodiscard]] std::uint64_t first_index() const { return before_[256]; }

  std::string damaged_;
};

// The directory leads to frame 256; the index that tells of the frames before it is found out to be
// damaged only while looking for those that it needs.
TEST_F(DamagedFirstIndex, found_on_the_way_costs_nothing) {
  auto reader = open(damaged_).value();
  EXPECT_TRUE(reader.damage().empty()) << "nobody has needed it";
  EXPECT_TRUE(reader.readable(256));
  EXPECT_EQ(reader.damage().size(), 1U);
  EXPECT_EQ(reader.damage()[0].byte, first_index());
  EXPECT_TRUE(is_read(reader, 256));
}

// Frame 256 comes once more, as one that needs no other: which of the two counts, where frame 255
// is lost and where it is not, cannot be told without the first index.
TEST_F(DamagedFirstIndex, found_while_the_file_grows_costs_nothing) {
  const RecordingHeader header = sample_header({3, 2});
  const auto encoded = PositionEncoder(codec_parameters(header), header.max_position_error_m)
                           .encode(positions(256), nullptr);
  const std::string without_255 = flipped(damaged_, before_[255] + record_head_bytes);
  for (const std::string& bytes : {damaged_, without_255}) {
    auto reader = open(bytes).value();
    ASSERT_EQ(reader.frame_count(), 258);
    const std::string again =
        make_record(RecordType::frame, frame_payload({.recording_id = reader.recording_id(),
                                                      .frame = 256,
                                                      .encoding = encoded->encoding,
                                                      .numbers = sample_numbers(256),
                                                      .geometry = encoded->geometry}));
    std::ofstream(path_, std::ios::app | std::ios::binary) << again << bytes.substr(before_[count]);
    ASSERT_TRUE(reader.refresh().has_value());
    EXPECT_TRUE(reader.finished()) << "it ends with a footer";
    EXPECT_EQ(reader.frame_count(), 258);
    EXPECT_EQ(reader.readable(255), bytes == damaged_);
    EXPECT_TRUE(is_read(reader, 256));
  }
}

// As a recorder leaves it that was killed just then, on a disk that lost its last frame.
TEST_F(DamagedFirstIndex, an_index_tells_of_lost_frames_at_the_end) {
  std::string bytes = read_file(path_).value();
  const auto index = parse_record_head(bytes.substr(first_index(), record_head_bytes));
  bytes.resize(first_index() + record_head_bytes + index->payload_bytes);
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(before_[255]),
            bytes.begin() + static_cast<std::ptrdiff_t>(first_index()), '\0');
  auto reader = open(bytes).value();
  EXPECT_EQ(reader.frame_count(), 256);
  EXPECT_FALSE(reader.readable(255));
}

// The file is that long, but most of it was never written.
TEST_F(DamagedRecording, a_record_that_claims_more_than_it_may_is_not_read) {
  constexpr std::uint64_t hole = std::uint64_t{1} << 36;
  std::string head = make_record(RecordType::frame, "");
  head.resize(8);
  put<std::uint64_t>(head, hole);
  put<std::uint32_t>(head, 0);
  put<std::uint32_t>(head, checksum(head));
  ASSERT_TRUE(write_file(path_, killed_ + head));
  std::filesystem::resize_file(path_, killed_.size() + hole);
  std::ofstream(path_, std::ios::app | std::ios::binary) << finished_.substr(killed_.size());
  auto reader = RecordingReader::open(path_).value();
  EXPECT_EQ(reader.frame_count(), frames);
  reader.check();
  ASSERT_GE(reader.damage().size(), 1U);
  EXPECT_EQ(reader.damage()[0].byte, killed_.size());
  EXPECT_EQ(reader.damage()[0].length, hole);
  EXPECT_EQ(reader.damage()[0].reason, std::string("a record claims to be larger than any"));
  std::filesystem::remove(path_);
}

// By its length the file could hold all of these frames, but most of it was never written.
TEST_F(DamagedRecording, a_directory_that_counts_what_only_a_hole_can_hold_is_not_believed) {
  constexpr std::uint64_t hole = std::uint64_t{1} << 38;
  const std::uint32_t id = open(finished_)->recording_id();
  const std::string directory = make_record(
      RecordType::directory, directory_payload(id, {3'000'000'000, RunEnding::tight, {}}));
  const std::string footer =
      make_record(RecordType::footer, footer_payload(id, killed_.size() + hole));
  ASSERT_TRUE(write_file(path_, killed_));
  std::filesystem::resize_file(path_, killed_.size() + hole);
  std::ofstream(path_, std::ios::app | std::ios::binary) << directory << footer;
  auto reader = RecordingReader::open(path_).value();
  EXPECT_EQ(reader.frame_count(), frames);
  EXPECT_TRUE(lost_frames(reader).empty());
  std::filesystem::remove(path_);
}

// The index knows it as the session of another frame.
TEST_F(DamagedRecording, a_session_of_another_frame_is_left_out) {
  std::string bytes = finished_;
  const std::size_t at = bytes.find(record_magic, end_[9]);
  ASSERT_EQ(at, end_[9]);
  Session session = session_;
  session.first_frame = 0xFFFFFFFF;
  const std::string forged =
      make_record(RecordType::session, session_payload(open(finished_)->recording_id(), session));
  ASSERT_EQ(forged.size(), begin_[10] - end_[9]);
  bytes.replace(at, forged.size(), forged);
  EXPECT_TRUE(open(bytes)->sessions().empty());
}

TEST_F(DamagedRecording, a_newer_major_version_is_refused_with_a_sentence) {
  std::string payload = header_payload(sample_header({3, 2}));
  payload[0] = 8;
  EXPECT_EQ(
      refusal_of(open(std::string(file_signature) + make_record(RecordType::header, payload))),
      path_.string() +
          ": was written in format version 8.0 by tests 1.0, this program reads version 7; use a "
          "newer program");
}

TEST_F(DamagedRecording, an_error_names_the_frame_as_users_count) {
  auto reader = open(flipped(killed_, begin_[5] + record_head_bytes + 3));
  Eigen::Matrix3Xf read;
  EXPECT_THAT(refusal_of(reader->read(7, read)), StartsWith(path_.string() + ": frame 8: "));
}

}  // namespace ribbon::damaged_recording_test
