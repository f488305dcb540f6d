#include "recording/writer/recording_writer.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "files/files.h"
#include "files/watched_disk.h"
#include "playback/recording_reader.h"
#include "playback/sample_frame.h"
#include "recording/codec/position_encoder.h"
#include "recording/sample_recording.h"
#include "recording/size_limit.h"
#include "result/refusal.h"

namespace ribbon::recording_writer_test {

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

TEST(RecordingWriter, an_older_file_is_replaced_only_where_that_is_wished) {
  const auto path = temporary_file("kept.rbn");
  ASSERT_TRUE(write_file(path, "older").has_value());
  EXPECT_THAT(refusal_of(RecordingWriter::create(path, sample_header(), Overwrite::no)),
              HasSubstr("kept.rbn: exists already"));
  EXPECT_EQ(read_file(path).value(), "older");
  EXPECT_TRUE(RecordingWriter::create(path, sample_header(), Overwrite::yes).has_value());
  std::filesystem::remove(path);
  EXPECT_TRUE(RecordingWriter::create(path, sample_header(), Overwrite::no).has_value());
  EXPECT_TRUE(RecordingWriter::create("/dev/null", sample_header(), Overwrite::no).has_value());
}

int frames_at(const std::filesystem::path& path) {
  return RecordingReader::open(path).value().frame_count();
}

TEST(RecordingWriter, an_older_recording_stays_until_the_new_one_has_a_frame) {
  const auto path = temporary_file("older") / "knot.rbn";
  {
    auto older = RecordingWriter::create(path, sample_header()).value();
    append_sample_frames(older, 0, 2);
  }
  EXPECT_TRUE(RecordingWriter::create(path, sample_header()).has_value()) << "and is given up";
  {
    const SizeLimit limit(1);
    EXPECT_FALSE(RecordingWriter::create(path, sample_header()).has_value());
  }
  EXPECT_EQ(frames_at(path), 2);
  EXPECT_TRUE(std::filesystem::hard_link_count(path) == 1 &&
              std::distance(std::filesystem::directory_iterator(path.parent_path()), {}) == 1)
      << "nothing is left beside it";

  ASSERT_TRUE(RecordingWriter::create(path, sample_header())->finish().has_value());
  EXPECT_EQ(frames_at(path), 2) << "no frame came";
  auto newer = RecordingWriter::create(path, sample_header()).value();
  EXPECT_EQ(frames_at(path), 2) << "there is no frame yet";
  append_sample_frames(newer, 0, 1);
  EXPECT_EQ(frames_at(path), 1);
  EXPECT_THAT(refusal_of(RecordingWriter::create(path, sample_header())),
              HasSubstr("is being written by another program"));
  append_sample_frames(newer, 1, 3);
  ASSERT_TRUE(newer.finish().has_value());
  EXPECT_EQ(frames_at(path), 3);
}

// A power cut must leave the one or the other.
TEST(RecordingWriter, an_older_recording_stays_until_the_new_one_is_on_the_disk) {
  const auto path = temporary_file("on the disk") / "knot.rbn";
  ASSERT_TRUE(write_file(path, "older"));
  auto newer = RecordingWriter::create(path, sample_header()).value();
  WatchedDisk disk;
  disk.refuse("sync", EIO);
  EXPECT_EQ(refusal_of(newer.append(sample_numbers(0), sample_positions(0))),
            path.string() + ": may not have reached the disk (Input/output error); check the disk");
  EXPECT_EQ(read_file(path).value(), "older");
  append_sample_frames(newer, 1, 2);
  EXPECT_THAT(disk.calls(),
              testing::ElementsAre("sync knot.rbn.part", "sync knot.rbn.part", "sync on the disk",
                                   "rename knot.rbn", "sync on the disk"));
}

TEST(RecordingWriter, a_disk_that_fails_is_told_but_not_one_that_needs_no_force) {
  auto writer = RecordingWriter::create(temporary_file("forced.rbn"), sample_header()).value();
  append_sample_frames(writer, 0, 2);
  ASSERT_TRUE(writer.sync());
  append_sample_frames(writer, 2, 3);
  WatchedDisk disk;
  disk.refuse("sync", EIO);
  EXPECT_THAT(refusal_of(writer.sync()), EndsWith("frames 1 to 2 are safe; check the disk"));
  disk.refuse("sync", EINVAL);
  EXPECT_TRUE(writer.finish().has_value()) << "as a pipe";
}

TEST(RecordingWriter, what_may_be_lost_at_the_end_is_told) {
  for (const char* call : {"sync", "close"}) {
    auto writer = RecordingWriter::create(temporary_file("lost at the end.rbn"), sample_header());
    append_sample_frames(*writer, 0, 1);
    WatchedDisk disk;
    disk.refuse(call, EIO);
    EXPECT_THAT(refusal_of(writer->finish()), HasSubstr("may not have reached the disk")) << call;
  }
}

TEST(RecordingWriter, an_older_recording_stays_as_long_as_is_wished) {
  const auto path = temporary_file("older take.rbn");
  ASSERT_TRUE(write_file(path, "older").has_value());
  auto newer = RecordingWriter::create(path, sample_header(), Overwrite::when_told).value();
  append_sample_frames(newer, 0, 2);
  EXPECT_EQ(read_file(path).value(), "older");
  EXPECT_EQ(frames_at(newer.present_path()), 2);
  ASSERT_TRUE(newer.take_place().has_value());
  EXPECT_EQ(newer.present_path(), path);
  EXPECT_EQ(frames_at(path), 2);
}

TEST(RecordingWriter, a_link_goes_on_to_lead_to_the_recording) {
  const auto path = temporary_file("behind a link.rbn");
  const auto link = temporary_file("link.rbn");
  ASSERT_TRUE(write_file(path, "older").has_value());
  std::filesystem::permissions(path, std::filesystem::perms(0640));
  std::filesystem::create_symlink(path, link);
  auto writer = RecordingWriter::create(link, sample_header()).value();
  append_sample_frames(writer, 0, 1);
  ASSERT_TRUE(writer.finish().has_value());
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(frames_at(path), 1);
  EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms(0640));
}

TEST(RecordingWriter, a_file_that_somebody_takes_away_is_told) {
  for (const auto& [name, harm] :
       {std::pair<const char*, std::function<void(const std::filesystem::path&)>>{
            "removed.rbn", [](const auto& path) { std::filesystem::remove(path); }},
        {"replaced.rbn", [](const auto& path) { (void)write_file(path, "another"); }},
        {"cut.rbn", [](const auto& path) { std::filesystem::resize_file(path, 10); }}}) {
    const auto path = temporary_file(name);
    auto writer = RecordingWriter::create(path, sample_header()).value();
    append_sample_frames(writer, 0, 2);
    harm(path);
    EXPECT_THAT(refusal_of(writer.finish()), HasSubstr("removed, replaced or cut it")) << name;
  }
}

TEST(RecordingWriter, each_frame_is_in_the_file_when_append_returns) {
  const auto path = temporary_file("each frame.rbn");
  auto writer = RecordingWriter::create(path, sample_header()).value();
  for (int frame = 0; frame < 40; ++frame) {
    append_sample_frames(writer, frame, frame + 1);
    EXPECT_EQ(writer.frames_written(), static_cast<std::uint32_t>(frame + 1));
    EXPECT_EQ(std::filesystem::file_size(path), writer.bytes_written());
    EXPECT_EQ(RecordingReader::open(path)->frame_count(), frame + 1);
  }
}

TEST(RecordingWriter, a_grid_that_no_reader_would_take_is_refused) {
  RecordingHeader header = sample_header();
  header.grid = {2, (1 << 20) + 1};
  header.uv = Eigen::Matrix2Xf::Zero(2, header.grid.particle_count());
  EXPECT_THAT(refusal_of(RecordingWriter::create(temporary_file("wide.rbn"), header)),
              HasSubstr("at most 2^20 columns, not 2 x 1048577"));
}

TEST(RecordingWriter, a_header_that_no_reader_would_take_is_refused) {
  const auto path = temporary_file("knot.rbn");
  ASSERT_TRUE(write_file(path, "an older one").has_value());
  for (const auto& spoil : std::initializer_list<void (*)(RecordingHeader&)>{
           [](RecordingHeader& header) { header.quantisation_step_m = 1e38; },
           [](RecordingHeader& header) { header.ribbon_length_m = 0; },
           [](RecordingHeader& header) { header.strain_limit = -1; }}) {
    RecordingHeader header = sample_header();
    spoil(header);
    EXPECT_THAT(refusal_of(RecordingWriter::create(path, header)),
                HasSubstr("knot.rbn: no reader would take its header"));
    EXPECT_EQ(read_file(path).value(), "an older one");
  }
}

TEST(RecordingWriter, an_obstacle_that_no_reader_would_take_is_refused) {
  const auto path = temporary_file("large.rbn");
  RecordingHeader header = sample_header();
  header.obstacle->vertices.resize(3, (1 << 26) + 1);
  EXPECT_EQ(refusal_of(RecordingWriter::create(path, header)),
            path.string() +
                ": a recording holds at most 2^26 vertices and as many triangles of its "
                "obstacle, not 67108865 and 8; take a coarser mesh");
  header = sample_header();
  header.obstacle->triangles.resize(3, (1 << 26) + 1);
  EXPECT_THAT(refusal_of(RecordingWriter::create(path, header)),
              HasSubstr("of its obstacle, not 6 and 67108865; take a coarser mesh"));
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(RecordingWriter, a_target_that_cannot_be_written_is_told_before_the_run) {
  EXPECT_THAT(refusal_of(RecordingWriter::create("/proc/recording.rbn", sample_header())),
              HasSubstr("/proc/recording.rbn: cannot be written ("));
}

TEST(RecordingWriter, a_full_disk_is_told_before_the_run) {
  EXPECT_EQ(refusal_of(RecordingWriter::create("/dev/full", sample_header())),
            "/dev/full: cannot be written (No space left on device); the recording holds no "
            "frame; free some space or choose another place");
  EXPECT_TRUE(RecordingWriter::create("/dev/full", sample_header()).error().may_pass);
}

TEST(RecordingWriter, when_the_disk_fills_up_everything_before_is_intact) {
  const auto path = temporary_file("full.rbn");
  auto writer = RecordingWriter::create(path, sample_header()).value();
  append_sample_frames(writer, 0, 3);
  Result<void> fourth;
  {
    const SizeLimit limit(writer.bytes_written() + 50);
    fourth = writer.append(sample_numbers(3), sample_positions(3));
  }
  EXPECT_EQ(refusal_of(fourth),
            path.string() +
                ": cannot be written (File too large); frames 1 to 3 are safe; free some space and "
                "resume the run");
  EXPECT_EQ(std::filesystem::file_size(path), writer.bytes_written())
      << "half a record must not stay behind";
  append_sample_frames(writer, 3, 4);  // space was freed
  ASSERT_TRUE(writer.finish().has_value());
  auto reader = RecordingReader::open(path).value();
  EXPECT_EQ(reader.frame_count(), 4);
  expect_sample_frame(reader, 3);
}

TEST(RecordingWriter, what_is_taken_back_leaves_what_was_there) {
  const auto path = temporary_file("taken back.rbn");
  const auto link = temporary_file("leads nowhere yet.rbn");
  const auto beside = temporary_file("beside.rbn");
  std::filesystem::create_symlink(path, link);
  ASSERT_TRUE(write_file(beside, "older"));
  for (const auto& name : {path, link, beside}) {
    auto writer = RecordingWriter::create(name, sample_header(), Overwrite::when_told).value();
    append_sample_frames(writer, 0, 2);
    writer.take_back();
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(read_file(beside).value(), "older");
}

TEST(RecordingWriter, what_somebody_else_has_put_in_its_place_is_not_taken_back) {
  const auto path = temporary_file("another's.rbn");
  auto writer = RecordingWriter::create(path, sample_header()).value();
  append_sample_frames(writer, 0, 2);
  ASSERT_TRUE(write_file(path, "another"));
  writer.take_back();
  EXPECT_EQ(read_file(path).value(), "another");
}

TEST(RecordingWriter, a_refused_frame_is_named_and_the_recording_goes_on) {
  const auto path = temporary_file("refused.rbn");
  auto writer = RecordingWriter::create(path, sample_header()).value();
  append_sample_frames(writer, 0, 1);
  Eigen::Matrix3Xd positions = sample_positions(1);
  positions(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal_of(writer.append(sample_numbers(1), positions)),
              StartsWith(path.string() + ": frame 2: "));
  append_sample_frames(writer, 1, 2);
  ASSERT_TRUE(writer.finish().has_value());
  EXPECT_EQ(RecordingReader::open(path)->frame_count(), 2);
}

TEST(RecordingWriter, two_writers_on_one_file_are_refused) {
  const auto path = temporary_file("two writers.rbn");
  auto first = RecordingWriter::create(path, sample_header());
  append_sample_frames(*first, 0, 1);
  EXPECT_EQ(refusal_of(RecordingWriter::create(path, sample_header())),
            path.string() +
                ": is being written by another program; wait until that has ended, or "
                "choose another file");
  EXPECT_EQ(RecordingReader::open(path)->frame_count(), 1) << "nothing was emptied";
  ASSERT_TRUE(first->finish().has_value());
  EXPECT_TRUE(RecordingWriter::create(path, sample_header()).has_value());
}

TEST(RecordingWriter, checkpoints_and_sessions_come_back) {
  const auto path = temporary_file("checkpoints.rbn");
  const SessionNote note{SessionReason::resumed, "tests 2.0", "time.step = 1\n"};
  {
    auto writer = RecordingWriter::create(path, sample_header());
    for (int frame = 0; frame < 600; ++frame) {
      append_sample_frames(*writer, frame, frame + 1);
      if (frame % 100 == 50) {
        ASSERT_TRUE(writer->append_checkpoint(10UL * frame, "state " + std::to_string(frame)));
      }
      if (frame == 299) {
        ASSERT_TRUE(writer->append_session(note).has_value());
      }
    }
    ASSERT_TRUE(writer->finish().has_value());
  }
  auto reader = RecordingReader::open(path);
  for (const bool walked : {false, true}) {
    if (walked) reader->check();
    EXPECT_EQ(reader->checkpoints(), (std::vector<std::uint32_t>{50, 150, 250, 350, 450, 550}));
    EXPECT_EQ(reader->read_checkpoint(350).value(), (Checkpoint{350, 3500, "state 350"}));
    EXPECT_EQ(reader->read_checkpoint(351).error().sentence(),
              path.string() +
                  ": frame 352: has no checkpoint; choose a frame that has one; --info lists them");
    EXPECT_EQ(reader->sessions(), (std::vector<Session>{{300, note}}));
  }
}

TEST(RecordingWriter, a_state_that_no_reader_would_take_is_refused) {
  const auto path = temporary_file("large state.rbn");
  auto writer = RecordingWriter::create(path, sample_header());
  append_sample_frames(*writer, 0, 1);
  EXPECT_FALSE(writer->append_checkpoint(1, std::string(240 * 4096 + (1 << 20) + 1, 'x')));
  EXPECT_TRUE(writer->append_checkpoint(1, std::string(240 * 4096 + (1 << 20), 'x')));
}

TEST(RecordingWriter, a_frame_is_predicted_from_the_one_before_it_in_its_group) {
  EXPECT_EQ(reference_of(group_frames + 7), group_frames + 6);
  EXPECT_EQ(reference_of(0), std::nullopt);
  EXPECT_EQ(reference_of(1), 0U);
  EXPECT_EQ(reference_of(group_frames), std::nullopt);
}

TEST(RecordingWriter, frames_encoded_by_others_may_come_in_any_order) {
  const auto path = temporary_file("any order.rbn");
  const RecordingHeader header = sample_header();
  PositionEncoder encoder(codec_parameters(header), header.max_position_error_m);
  std::vector<QuantisedFrame> frames(5);
  const std::vector<std::optional<std::uint32_t>> references = {{}, 2, 4, 2, 0};
  {
    auto writer = RecordingWriter::create(path, header);
    for (const std::uint32_t frame : {0U, 4U, 2U, 1U, 3U}) {
      FrameRecord record{.frame = frame,
                         .reference = references[frame],
                         .numbers = sample_numbers(static_cast<int>(frame))};
      auto encoded = encoder.encode(sample_positions(static_cast<int>(frame)),
                                    record.reference ? &frames[*record.reference] : nullptr);
      record.encoding = encoded->encoding;
      record.geometry = encoded->geometry;
      ASSERT_TRUE(writer->append_encoded(record).has_value());
      frames[frame] = std::move(encoded->frame);
    }
    EXPECT_EQ(writer->frames_written(), 5U);
    ASSERT_TRUE(writer->finish().has_value());
  }
  auto reader = RecordingReader::open(path);
  ASSERT_EQ(reader->frame_count(), 5);
  for (const bool walked : {false, true}) {
    if (walked) reader->check();
    for (int frame = 0; frame < 5; ++frame) expect_sample_frame(*reader, frame);
  }
}

}  // namespace ribbon::recording_writer_test
