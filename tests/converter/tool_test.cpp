// The built ribbon-convert, as a user meets it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "commandline/tool_run.h"
#include "continuation/resume_recording.h"
#include "files/files.h"
#include "files/flipped.h"
#include "model/placement.h"
#include "model/sample_knot.h"
#include "model/sample_picture.h"
#include "obstacle/obstacle.h"
#include "playback/recording_reader.h"
#include "recording/sample_recording.h"
#include "recording/writer/recording_writer.h"

namespace ribbon::tool_test {

namespace fs = std::filesystem;

// The sample's 48 particles in a point cache.
constexpr std::size_t sample_bytes = std::size_t{48} * 12;

Eigen::Matrix3Xf cached_sample(const std::string& cache, std::size_t sample) {
  Eigen::Matrix3Xf positions(3, 48);
  std::memcpy(positions.data(), cache.data() + 32 + sample * sample_bytes, sample_bytes);
  return positions;
}

SampleKnot without_obstacle() {
  SampleKnot knot = sample_knot();
  knot.header.obstacle.reset();
  return knot;
}

// Of so many frames.
SampleKnot longer_knot(std::size_t frames) {
  SampleKnot knot = sample_knot();
  while (knot.frames.size() < frames)
    knot.frames.push_back(
        sample_wave(knot.header.grid, 0.1 * static_cast<double>(knot.frames.size())));
  return knot;
}

// What stands in an OBJ behind the name of its material library.
std::string objects_of(const std::string& obj) {
  return obj.substr(obj.find("\no "));
}

class Tool : public ToolTest {
 protected:
  Tool() : ToolTest(RIBBON_CONVERT) { record(sample_knot()); }

  // Frames beyond `penetrating` have no penetrating edges.
  void record(const SampleKnot& knot, const std::vector<std::uint32_t>& penetrating = {},
              Ending ending = Ending::finished) const {
    auto writer = RecordingWriter::create(recording_, knot.header).value();
    for (std::size_t frame = 0; frame < knot.frames.size(); ++frame) {
      FrameNumbers numbers = sample_numbers(static_cast<int>(frame));
      numbers.penetrating_edges = frame < penetrating.size() ? penetrating[frame] : 0;
      ASSERT_TRUE(writer.append(numbers, knot.frames[frame]));
    }
    ASSERT_TRUE(ending == Ending::killed || writer.finish());
  }

  fs::path recording_ = folder_ / "knot.rbn";
};

TEST_F(Tool, an_obj_sequence_shares_one_material_library) {
  EXPECT_THAT(output_of(run("knot.rbn -o 'out/knot.{frame:04}.obj'")), StartsWith("5 frames"));
  EXPECT_THAT(names("out"), ElementsAre("knot.0001.obj", "knot.0002.obj", "knot.0003.obj",
                                        "knot.0004.obj", "knot.0005.obj", "knot.mtl"));
  EXPECT_THAT(bytes("out/knot.0005.obj"), HasSubstr("mtllib knot.mtl\n"));
}

TEST_F(Tool, the_number_of_threads_changes_nothing) {
  record(longer_knot(22));
  ASSERT_EQ(run("knot.rbn -o '1/{frame}.obj' --threads 1").exit_code, 0);
  ASSERT_EQ(run("knot.rbn -o '2/{frame}.obj' --threads 2").exit_code, 0);
  ASSERT_EQ(names("1"), names("2"));
  EXPECT_EQ(names("1").size(), 22U + 1);
  for (const std::string& name : names("1"))
    EXPECT_TRUE(bytes("1/" + name) == bytes("2/" + name)) << name;
}

TEST_F(Tool, an_fbx_sequence_has_one_file_a_frame) {
  EXPECT_EQ(output_of(run("knot.rbn -o 'out/knot.{frame:04}.fbx' --frames 2:4 --quiet")), "");
  EXPECT_THAT(names("out"), ElementsAre("knot.0002.fbx", "knot.0003.fbx", "knot.0004.fbx"));
  EXPECT_THAT(bytes("out/knot.0002.fbx"), StartsWith("Kaydara FBX Binary"));
}

TEST_F(Tool, a_point_cache_equals_the_recording_and_has_its_base) {
  ASSERT_EQ(run("knot.rbn -o out/knot.pc2").exit_code, 0);
  EXPECT_THAT(names("out"), ElementsAre("knot.mtl", "knot.obj", "knot.pc2"));
  const std::string cache = bytes("out/knot.pc2");
  ASSERT_EQ(cache.size(), 32 + 5 * sample_bytes);
  auto reader = RecordingReader::open(recording_).value();
  for (int frame = 0; frame < 5; ++frame) {
    Eigen::Matrix3Xf recorded;
    ASSERT_TRUE(reader.read(frame, recorded));
    EXPECT_EQ(cached_sample(cache, static_cast<std::size_t>(frame)), recorded) << "frame " << frame;
  }
  ASSERT_EQ(run("knot.rbn -o first.obj --frames 1").exit_code, 0);
  EXPECT_EQ(objects_of(bytes("out/knot.obj")), objects_of(bytes("first.obj")));
}

TEST_F(Tool, a_recording_that_intersects_is_told) {
  record(sample_knot(), {0, 3, 7, 7, 0});
  const std::string all = "ribbon-convert: the recording intersects, and so do the files: ";
  EXPECT_THAT(
      run("knot.rbn -o a.abc --quiet").errors,
      StartsWith(all + "in 3 of 5 frames, first in frame 2, worst in frame 3, where 7 edges "
                       "pierce triangles\n"));
  const ToolRun few = run("knot.rbn -o '{frame}.obj' --frames 1:2");
  EXPECT_EQ(few.exit_code, 0);
  EXPECT_THAT(few.errors, HasSubstr("in 1 of 2 frames, first in frame 2, worst in frame 2"));
  for (const std::string silent : {"b.abc --frames 1", "a.rbn", "a.csv", "a.obj --object obstacle"})
    output_of(run("knot.rbn -o " + silent));
  SampleKnot with_gap = sample_knot();
  with_gap.header.stated_gap_m = 1e-6;
  record(with_gap, {0, 3, 7, 7, 0});
  output_of(run("knot.rbn -o c.abc"));
}

TEST_F(Tool, a_recording_that_has_no_end_is_told_where_its_last_frame_is_asked_for) {
  record(sample_knot(), {}, Ending::killed);
  for (const std::string output : {"a.abc", "'{frame}.obj' --frames -2:", "a.csv", "a.rbn"}) {
    const ToolRun stopped = run("knot.rbn --quiet -o " + output);
    EXPECT_EQ(stopped.exit_code, 0);
    EXPECT_EQ(stopped.errors,
              "ribbon-convert: the recording is unfinished: it ends with frame 5, where its "
              "recorder was stopped\n");
  }
  output_of(run("knot.rbn -o b.abc --frames 1:4"));
  output_of(run("knot.rbn -o b.obj --object obstacle"));
  auto writer = resume_recording(recording_).value();
  EXPECT_THAT(run("knot.rbn -o c.abc").errors,
              HasSubstr("it ends with frame 5, and is still being written"));
  ASSERT_TRUE(writer.finish(RunEnding::stopped));
  EXPECT_THAT(run("knot.rbn -o d.abc").errors, HasSubstr("where its recorder was stopped"));
}

TEST_F(Tool, the_last_frame_alone_needs_no_pattern) {
  ASSERT_EQ(run("knot.rbn -o last.obj --frames -1").exit_code, 0);
  EXPECT_THAT(names("."), ElementsAre("knot.rbn", "last.mtl", "last.obj"));
}

TEST_F(Tool, the_obstacle_can_be_left_out) {
  ASSERT_EQ(run("knot.rbn -o a.obj --frames 1 --object ribbon").exit_code, 0);
  EXPECT_THAT(bytes("a.obj"), Not(HasSubstr("small object")));
  EXPECT_THAT(bytes("a.mtl"), Not(HasSubstr("obstacle")));
}

TEST_F(Tool, the_obstacle_alone_is_one_file) {
  EXPECT_THAT(output_of(run("knot.rbn -o rock.obj --object obstacle")), HasSubstr("rock.obj"));
  EXPECT_THAT(names("."), ElementsAre("knot.rbn", "rock.mtl", "rock.obj"));
  EXPECT_THAT(bytes("rock.obj"), AllOf(HasSubstr("o small object"), Not(HasSubstr("o first"))));
  expect_refusal(run("knot.rbn -o 'rock.{frame}.obj' --object obstacle"), "leave {frame} out");
  expect_refusal(run("knot.rbn -o rock.pc2 --object obstacle"), ".obj or .fbx");
  expect_refusal(run("knot.rbn -o a.obj --object obstacle --frames 1"), "--frames");
}

TEST_F(Tool, axes_unit_and_scale_reach_the_numbers) {
  ASSERT_EQ(run("knot.rbn -o m.pc2").exit_code, 0);
  ASSERT_EQ(run("knot.rbn -o cm.pc2 --up z --unit cm --scale 0.5").exit_code, 0);
  const Placement placement{.up = UpAxis::z, .metres_per_unit = 0.01, .scale = 0.5};
  EXPECT_EQ(cached_sample(bytes("cm.pc2"), 1), placement.place(cached_sample(bytes("m.pc2"), 1)));
}

// 3 x three of each triangle: whoever reads a file may number its vertices anew.
Eigen::Matrix3Xf corners_of(const TriangleMesh& mesh) {
  return mesh.vertices(Eigen::all, mesh.triangles.reshaped());
}

// Single precision has rounded centimetres.
TEST_F(Tool, an_obstacle_that_goes_out_as_fbx_comes_back_in_metres_and_y_up) {
  const TriangleMesh rock = sample_knot().header.obstacle.value();
  for (const std::string settings :
       {"--up y --unit m", "--up y --unit cm", "--up z --unit m", "--up z --unit cm"}) {
    ASSERT_EQ(run("knot.rbn -o rock.fbx --force --object obstacle " + settings).exit_code, 0);
    ObstacleScene scene;
    scene.file.path = folder_ / "rock.fbx";
    const TriangleMesh read = read_obstacle(scene).value();
    EXPECT_TRUE(corners_of(read).isApprox(corners_of(rock), 1e-6F)) << settings << "\n"
                                                                    << corners_of(read);
  }
}

TEST_F(Tool, what_a_format_has_no_place_for_is_refused) {
  expect_refusal(run("knot.rbn -o '{frame}.obj' --fps 24"), "--fps");
  expect_refusal(run("knot.rbn -o a.pc2 --fps 24"), "--fps");
  expect_refusal(run("knot.rbn -o a.pc2 --start-frame 1001"), "--start-frame");
  expect_refusal(run("knot.rbn -o a.pc2 --normals"), "--normals");
  expect_refusal(run("knot.rbn -o a.pc2 --resume"), "--resume");
  expect_refusal(run("knot.rbn -o a.rbn --fps 24"),
                 "keeps the rate of its frames; leave --fps out");
  EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
}

TEST_F(Tool, numbers_of_files_can_begin_anywhere_and_leave_none_out) {
  ASSERT_EQ(run("knot.rbn -o 'out/{frame}.fbx' --frames ::2 --start-frame 1001").exit_code, 0);
  EXPECT_THAT(names("out"), ElementsAre("1001.fbx", "1002.fbx", "1003.fbx"));
  ASSERT_EQ(run("knot.rbn -o 'zero/{frame}.fbx' --frames 2 --start-frame 0").exit_code, 0);
  EXPECT_THAT(names("zero"), ElementsAre("0000.fbx"));
}

TEST_F(Tool, the_recording_itself_is_never_replaced) {
  const std::string whole = bytes("knot.rbn");
  std::filesystem::create_symlink("knot.rbn", folder_ / "link.rbn");
  for (const std::string words :
       {"knot.rbn -o ./knot.rbn --frames 1:3", "link.rbn -o knot.rbn", "knot.rbn -o link.rbn"})
    for (const std::string how : {" --force", " --dry-run"})
      expect_refusal(run(words + how), "is the recording that is converted");
  EXPECT_TRUE(bytes("knot.rbn") == whole);
}

TEST_F(Tool, nothing_is_overwritten_unasked) {
  for (const std::string output : {"'a.{frame}.obj'", "b.pc2", "'c.{frame}.fbx'"}) {
    ASSERT_EQ(run("knot.rbn -o " + output).exit_code, 0);
    const std::string again = "knot.rbn --object ribbon -o " + output;
    expect_refusal(run(again), "exists already; replace it by --force");
    EXPECT_EQ(run(again + " --force").exit_code, 0);
  }
}

TEST_F(Tool, a_single_file_in_the_way_stops_all) {
  ASSERT_TRUE(write_file(folder_ / "a.0005.obj", "mine"));
  expect_refusal(run("knot.rbn -o 'a.{frame}.obj'"), "a.0005.obj: exists already");
  EXPECT_THAT(names("."), ElementsAre("a.0005.obj", "knot.rbn"));
}

TEST_F(Tool, a_material_library_is_shared_by_those_who_write_the_same) {
  ASSERT_EQ(run("knot.rbn -o 'a.{frame}.obj'").exit_code, 0);
  EXPECT_EQ(run("knot.rbn -o a.pc2").exit_code, 0);
  expect_refusal(run("knot.rbn -o a_.pc2 --object ribbon"), "a.mtl: exists already");
}

TEST_F(Tool, a_dry_run_tells_and_writes_nothing) {
  EXPECT_THAT(output_of(run("knot.rbn -o 'out/a.{frame}.obj' --dry-run")),
              AllOf(StartsWith("would write 6 files, 0.0"), HasSubstr(" MB (± "),
                    HasSubstr("out/a.0001.obj ... out/a.0005.obj")));
  EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
  ASSERT_EQ(run("knot.rbn -o a.pc2").exit_code, 0);
  EXPECT_THAT(output_of(run("knot.rbn -o a.pc2 --dry-run")),
              AllOf(StartsWith("would write 3 files"), HasSubstr("2 of them exist already")));
  EXPECT_EQ(run("knot.rbn -o a.pc2 --fps 3 --dry-run").exit_code, 2);
}

// A conversion that stopped at frame 3, because a folder stood in its way.
class StoppedConversion : public Tool {
 protected:
  void SetUp() override {
    ASSERT_TRUE(write_file(folder_ / "a.0003.obj/in the way", ""));
    ASSERT_EQ(run(command_ + " --threads 1 --force").exit_code, 2);
    EXPECT_TRUE(fs::remove_all(folder_ / "a.0003.obj"));
    ASSERT_THAT(names("."),
                ElementsAre("a.0001.obj", "a.0002.obj", "a.mtl", "a.obj.unfinished", "knot.rbn"));
  }

  std::string command_ = "knot.rbn -o 'a.{frame}.obj'";
};

TEST_F(StoppedConversion, goes_on_with_what_is_missing) {
  const auto before = fs::last_write_time(folder_ / "a.0002.obj");
  EXPECT_THAT(output_of(run(command_ + " --resume")), StartsWith("5 frames, 2 of them kept"));
  EXPECT_EQ(fs::last_write_time(folder_ / "a.0002.obj"), before);
  EXPECT_THAT(names("."), ElementsAre("a.0001.obj", "a.0002.obj", "a.0003.obj", "a.0004.obj",
                                      "a.0005.obj", "a.mtl", "knot.rbn"));
  ASSERT_EQ(run("knot.rbn -o 'b.{frame}.obj'").exit_code, 0);
  for (const std::string frame : {"1", "2", "3", "4", "5"})
    EXPECT_EQ(objects_of(bytes("a.000" + frame + ".obj")),
              objects_of(bytes("b.000" + frame + ".obj")));
}

TEST_F(StoppedConversion, removes_what_a_kill_has_left_of_its_files) {
  const std::string others = "b.0003.obj.part99";
  for (const std::string& leftover :
       {std::string("a.0003.obj.part99"), std::string("a.mtl.part99"), others})
    ASSERT_TRUE(write_file(folder_ / leftover, "half a file"));
  expect_refusal(run(command_ + " --resume --up z"), "other settings");
  EXPECT_TRUE(fs::exists(folder_ / "a.0003.obj.part99")) << "of what was not gone on with";
  ASSERT_EQ(run(command_ + " --resume").exit_code, 0);
  EXPECT_THAT(names("."), ElementsAre("a.0001.obj", "a.0002.obj", "a.0003.obj", "a.0004.obj",
                                      "a.0005.obj", "a.mtl", others, "knot.rbn"));
}

TEST_F(StoppedConversion, files_that_were_touched_since_are_written_again) {
  const std::string one = bytes("a.0001.obj");
  const std::string other = bytes("a.0002.obj");
  ASSERT_TRUE(write_file(folder_ / "a.0001.obj", flipped(one, one.size() / 2, 1)));
  ASSERT_TRUE(write_file(folder_ / "a.0002.obj", other.substr(1)));
  EXPECT_EQ(output_of(run(command_ + " --resume")).find("kept"), std::string::npos);
  EXPECT_EQ(bytes("a.0001.obj"), one);
  EXPECT_EQ(bytes("a.0002.obj"), other);
}

TEST_F(StoppedConversion, can_be_stopped_again_before_anything_is_added) {
  ASSERT_TRUE(write_file(folder_ / "a.0003.obj/in the way", ""));
  EXPECT_EQ(run(command_ + " --threads 1 --resume").exit_code, 2);
  EXPECT_TRUE(fs::remove_all(folder_ / "a.0003.obj"));
  EXPECT_THAT(output_of(run(command_ + " --resume")), StartsWith("5 frames, 2 of them kept"));
}

TEST_F(StoppedConversion, with_other_settings_is_refused) {
  expect_refusal(run(command_ + " --resume --up z"), "other settings");
  expect_refusal(run(command_ + " --resume --frames 1:4"), "other settings");
  expect_refusal(run(command_ + " --resume --start-frame 0"), "other settings");
  ASSERT_TRUE(write_file(folder_ / "cloth.png", sample_png()));
  expect_refusal(run(command_ + " --resume --texture cloth.png"), "other settings");
}

TEST_F(Tool, a_file_in_the_place_of_the_log_tells_of_no_conversion) {
  ASSERT_TRUE(write_file(folder_ / "a.obj.unfinished", "mine"));
  expect_refusal(run("knot.rbn -o 'a.{frame}.obj'"), "a.obj.unfinished: exists already; replace");
  expect_refusal(run("knot.rbn -o 'a.{frame}.obj' --resume"),
                 "a.obj.unfinished: is no log of a conversion that was stopped; name another file");
}

TEST_F(StoppedConversion, of_another_recording_is_refused) {
  SampleKnot knot = sample_knot();
  knot.frames.pop_back();
  record(knot);
  expect_refusal(run(command_ + " --resume --frames :"), "another recording");
}

TEST_F(StoppedConversion, without_a_word_is_refused) {
  expect_refusal(run(command_), "go on with it by --resume, or begin anew with --force");
}

TEST_F(StoppedConversion, can_begin_anew) {
  EXPECT_THAT(output_of(run(command_ + " --force")), StartsWith("5 frames, 0.0 MB"));
  EXPECT_FALSE(fs::exists(folder_ / "a.obj.unfinished"));
}

// As what was stopped before its first file; once all are there it replaces none.
TEST_F(Tool, what_has_not_begun_goes_on_from_its_beginning) {
  EXPECT_EQ(run("knot.rbn -o 'a.{frame}.obj' --resume --force").exit_code, 2);
  EXPECT_THAT(output_of(run("knot.rbn -o 'a.{frame}.obj' --resume")),
              StartsWith("5 frames, 0.0 MB"));
  EXPECT_FALSE(fs::exists(folder_ / "a.obj.unfinished"));
  expect_refusal(run("knot.rbn -o 'a.{frame}.obj' --resume"), "a.0001.obj: exists already");
}

TEST_F(Tool, several_frames_without_a_pattern_are_refused) {
  expect_refusal(run("knot.rbn -o out/knot.obj"), "{frame");
  EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
}

TEST_F(Tool, a_whole_motion_with_a_pattern_is_refused) {
  expect_refusal(run("knot.rbn -o 'knot.{frame}.pc2'"), "leave {frame} out");
}

TEST_F(Tool, the_numbers_of_each_frame_become_a_table) {
  record(sample_knot(), {0, 1, 2});
  EXPECT_THAT(output_of(run("knot.rbn -o out/knot.csv --frames 2:3")), StartsWith("2 frames"));
  EXPECT_THAT(bytes("out/knot.csv"), StartsWith("frame,time [s],"));
  EXPECT_THAT(bytes("out/knot.csv"), HasSubstr("\n3,0.04,0.002,2,4,"));
}

TEST_F(Tool, what_a_table_cannot_show_is_refused) {
  for (const std::string option : {"--up z", "--unit cm", "--scale 2", "--object ribbon",
                                   "--object obstacle", "--faces quads", "--thickness 0.001"})
    expect_refusal(run("knot.rbn -o a.csv " + option), "no positions; leave --up, --unit");
}

TEST_F(Tool, an_fbx_without_a_number_holds_the_whole_motion) {
  EXPECT_EQ(run("knot.rbn -o a.fbx").errors, "");
  EXPECT_THAT(names("."), ElementsAre("a.fbx", "knot.rbn"));
  EXPECT_THAT(bytes("a.fbx"), HasSubstr("BlendShapeChannel"));
  ASSERT_EQ(run("knot.rbn -o rock.fbx --object obstacle").exit_code, 0);
  EXPECT_THAT(bytes("rock.fbx"), AllOf(StartsWith("Kaydara"), Not(HasSubstr("BlendShape"))));
}

TEST_F(Tool, what_other_programs_do_with_a_file_is_told) {
  EXPECT_THAT(run("knot.rbn -o a.fbx --fps 29.97").errors,
              HasSubstr("29.97 frames a second as 30"));
  EXPECT_THAT(run("knot.rbn -o a.glb --fps 29.97").errors,
              HasSubstr("29.97 frames a second as 30"));
  for (const std::string output : {"'{frame}.fbx'", "a.abc", "a.usda", "a.mdd"})
    EXPECT_EQ(run("knot.rbn --fps 29.97 -o " + output).errors, "") << output;
}

TEST_F(Tool, what_was_written_is_read_back) {
  for (const std::string output : {"out/a.abc", "'out/a.{frame}.obj'"})
    EXPECT_THAT(output_of(run("knot.rbn --verify -o " + output)),
                AllOf(StartsWith("5 frames"), EndsWith("5 frames: exactly as recorded\n")));
  EXPECT_EQ(output_of(run("knot.rbn --verify-only --quiet -o out/a.abc")), "");
}

TEST_F(Tool, a_file_that_is_not_as_recorded_is_exit_code_1) {
  ASSERT_EQ(run("knot.rbn -o a.npy --scale 1.01").exit_code, 0);
  const ToolRun answer = run("knot.rbn -o a.npy --verify-only");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_THAT(answer.errors, HasSubstr("only 0 m is allowed"));
  EXPECT_EQ(run("knot.rbn -o a.npy --verify-only --tolerance 0.1").exit_code, 0);
  EXPECT_EQ(run("knot.rbn -o b.npy --verify-only").exit_code, 1);
  EXPECT_THAT(names("."), ElementsAre("a.npy", "knot.rbn"));
}

TEST_F(Tool, what_cannot_be_verified_is_not_written) {
  for (const std::string output : {"a.csv", "a.rbn"})
    expect_refusal(run("knot.rbn --verify -o " + output), "leave --verify out");
  EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
}

TEST_F(Tool, an_unknown_extension_is_one_sentence_that_lists_the_known) {
  expect_refusal(
      run("knot.rbn -o 'knot.{frame}.ply'"),
      "knot.{frame}.ply: is not written as .ply (assimp merges ribbon and obstacle, and "
      "the format does not say which way is up); choose .obj or .fbx (one file a frame), ");
}

TEST_F(Tool, a_frame_that_is_not_there_is_refused) {
  EXPECT_EQ(run("knot.rbn -o a.obj --frames 6").exit_code, 2);
  EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
}

TEST_F(Tool, a_missing_recording_and_a_wrong_option_could_not) {
  expect_refusal(run("other.rbn -o a.pc2"), "other.rbn");
  EXPECT_EQ(run("knot.rbn -o a.pc2 --speed 3").exit_code, 2);
  EXPECT_EQ(run("knot.rbn").exit_code, 2);
}

TEST_F(Tool, empty_values_are_no_wish) {
  expect_refusal(run("knot.rbn -o a.abc --frames ''"), "--frames: is followed by an empty text");
  expect_refusal(run("knot.rbn -o ''"), "--output: is followed by an empty text");
}

TEST_F(Tool, help_shows_examples_and_version_a_number) {
  EXPECT_THAT(output_of(run("--help")),
              HasSubstr("ribbon-convert knot.rbn -o 'out/knot.{frame:04}.obj'"));
  EXPECT_THAT(output_of(run("--version")), StartsWith("ribbon-convert "));
}

// A recording of 60 frames with one byte changed in the middle.
class DamagedRecording : public Tool {
 protected:
  void SetUp() override {
    SampleKnot knot = sample_knot();
    knot.frames.clear();
    for (int frame = 0; frame < 60; ++frame)
      knot.frames.push_back(sample_wave(knot.header.grid, 0.1 * frame));
    record(knot);
    ASSERT_TRUE(write_file(recording_, flipped(bytes("knot.rbn"), fs::file_size(recording_) / 2)));
    auto reader = RecordingReader::open(recording_).value();
    Eigen::Matrix3Xf positions;
    for (int frame = 0; frame < reader.frame_count(); ++frame)
      (reader.read(frame, positions) ? good_ : lost_).push_back(frame);
    ASSERT_EQ(reader.frame_count(), 60);
    ASSERT_FALSE(lost_.empty());
    ASSERT_FALSE(good_.empty());
  }

  std::vector<int> good_;
  std::vector<int> lost_;
};

TEST_F(DamagedRecording, the_good_frames_are_written_and_the_lost_are_listed) {
  const ToolRun answer = run("knot.rbn -o 'out/{frame:03}.obj'");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_THAT(answer.errors, HasSubstr("lost " + std::to_string(lost_.size()) +
                                       " of the frames: " + std::to_string(lost_.front() + 1)));
  EXPECT_THAT(answer.errors, HasSubstr("damaged at byte"));
  EXPECT_EQ(names("out").size(), good_.size() + 1);
}

// The index still knows these.
TEST_F(DamagedRecording, a_table_holds_the_numbers_of_lost_frames_and_lists_these) {
  const ToolRun answer = run("knot.rbn -o a.csv");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_THAT(answer.output, StartsWith("60 frames"));
  EXPECT_THAT(answer.errors,
              AllOf(HasSubstr("damaged at byte"),
                    HasSubstr("lost " + std::to_string(lost_.size()) +
                              " of the frames: " + std::to_string(lost_.front() + 1))));
  EXPECT_THAT(bytes("a.csv"), Not(HasSubstr(",,,,,,")));
}

TEST_F(DamagedRecording, a_point_cache_holds_the_frame_before_a_lost_one) {
  const ToolRun answer = run("knot.rbn -o a.pc2");
  EXPECT_EQ(answer.exit_code, 1);
  const std::string cache = bytes("a.pc2");
  ASSERT_EQ(cache.size(), 32 + 60 * sample_bytes);
  ASSERT_GT(lost_.front(), 1);
  const auto lost = static_cast<std::size_t>(lost_.front());
  EXPECT_EQ(cached_sample(cache, lost), cached_sample(cache, lost - 1));
  EXPECT_NE(cached_sample(cache, lost - 1), cached_sample(cache, lost - 2));
}

TEST_F(DamagedRecording, what_could_be_written_is_as_recorded) {
  for (const std::string output : {"a.pc2", "a.usda", "'out/{frame:03}.obj'"}) {
    const ToolRun answer = run("knot.rbn --verify -o " + output);
    EXPECT_EQ(answer.exit_code, 1);
    EXPECT_THAT(answer.output, HasSubstr("exactly as recorded")) << output;
  }
}

TEST_F(DamagedRecording, is_told_without_a_conversion_too) {
  const std::string lost = "lost " + std::to_string(lost_.size()) + " of the frames: ";
  for (const std::string output : {"a.pc2", "a.usda", "'out/{frame:03}.obj'"}) {
    ASSERT_EQ(run("knot.rbn -o " + output).exit_code, 1);
    const ToolRun answer = run("knot.rbn --verify-only -o " + output);
    EXPECT_EQ(answer.exit_code, 1) << output;
    EXPECT_THAT(answer.errors, AllOf(HasSubstr("damaged at byte"), HasSubstr(lost))) << output;
    EXPECT_THAT(answer.output, HasSubstr("exactly as recorded")) << output;
  }
}

TEST_F(DamagedRecording, a_point_cache_starts_with_the_first_good_frame) {
  std::string first = std::to_string(lost_.front() + 1);
  ASSERT_EQ(run("knot.rbn -o a.pc2 --frames " + first + ":-1").exit_code, 1);
  const std::string cache = bytes("a.pc2");
  const auto later =
      std::find_if(good_.begin(), good_.end(), [&](int frame) { return frame > lost_.front(); });
  ASSERT_NE(later, good_.end());
  Eigen::Matrix3Xf expected;
  ASSERT_TRUE(RecordingReader::open(recording_).value().read(*later, expected));
  EXPECT_EQ(cached_sample(cache, 0), expected);
}

TEST_F(DamagedRecording, lost_frames_alone_could_not) {
  const std::string first = "knot.rbn --frames " + std::to_string(lost_.front() + 1);
  for (const std::string output : {" -o a.pc2", " -o a.fbx"}) {
    EXPECT_EQ(run(first + output).exit_code, 2);
    EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
  }
}

TEST_F(DamagedRecording, of_lost_frames_alone_nothing_is_as_recorded) {
  const std::string first = "knot.rbn --verify-only --frames " + std::to_string(lost_.front() + 1);
  for (const std::string output : {" -o a.pc2", " -o a.obj"})
    expect_refusal(run(first + output), "none of the frames can be read");
}

TEST_F(Tool, an_unwritable_folder_is_named) {
  for (const std::string name : {"{frame}.obj", "{frame}.fbx", "a.pc2", "a.csv"})
    expect_refusal(run("knot.rbn -o 'knot.rbn/below/" + name + "'"), "knot.rbn/below");
}

TEST_F(Tool, a_disk_that_fills_up_leaves_no_half_file) {
  for (const std::string output : {"out/a.{frame}.obj", "out/a.{frame}.fbx", "out/a.pc2"}) {
    // 1 or 2 kB.
    expect_refusal(run("knot.rbn -o '" + output + "'", "ulimit -f 2 &&"), "cannot be written");
    EXPECT_THAT(names("out"), testing::Each(testing::AnyOf("a.mtl", "a.obj.unfinished")));
  }
}

TEST_F(Tool, a_dry_run_without_a_temporary_folder_says_so) {
  for (const std::string output : {"a.pc2", "a.rbn"})
    expect_refusal(run("knot.rbn --dry-run -o " + output, "TMPDIR=/gone"),
                   "the temporary folder: cannot be used (No such file or directory); name another "
                   "one in the environment variable TMPDIR\n");
}

// The part of an excerpt, in which frames would be safe, goes.
TEST_F(Tool, a_recording_that_cannot_be_written_whole_is_not_called_safe) {
  record(longer_knot(60));
  ASSERT_GT(fs::file_size(recording_), 8 * 1024U);
  expect_refusal(run("knot.rbn -o out/a.rbn", "ulimit -f 8 &&"),
                 "out/a.rbn: cannot be written (File too large); choose another place\n");
  EXPECT_THAT(names("out"), ElementsAre());
}

// Vertices coincide in the third frame of the sample, and its obstacle is in the way.
TEST_F(Tool, frames_that_cannot_be_made_a_solid_are_named_and_the_others_written) {
  record(without_obstacle());
  const auto sequence = run("knot.rbn -o 'out/{frame}.obj' --thickness 0.001");
  EXPECT_EQ(sequence.exit_code, 1);
  EXPECT_THAT(sequence.errors, HasSubstr("1 of the frames cannot be made a solid: 3"));
  EXPECT_THAT(sequence.output, HasSubstr("the ribbon is at least"));
  EXPECT_THAT(names("out"),
              ElementsAre("0001.obj", "0002.obj", "0004.obj", "0005.obj", "ribbon.mtl"));
}

TEST_F(Tool, verification_does_not_miss_a_frame_that_cannot_be_made_a_solid) {
  record(without_obstacle());
  for (const std::string output : {"'out/{frame}.obj'", "knot.mdd", "knot.glb"}) {
    const std::string conversion = "knot.rbn --force --thickness 0.001 -o " + output;
    EXPECT_EQ(run(conversion).exit_code, 1);
    EXPECT_EQ(run(conversion + " --verify-only").exit_code, 0) << output;
  }
}

TEST_F(Tool, verification_knows_that_a_motion_begins_with_the_first_frame_that_is_a_solid) {
  record(without_obstacle());
  for (const std::string output : {"a.abc", "a.fbx", "a.glb", "a.mdd", "a.pc2", "a.usda"}) {
    const ToolRun conversion =
        run("knot.rbn --frames 3: --thickness 0.001 --force --verify --quiet -o " + output);
    EXPECT_EQ(conversion.errors, "ribbon-convert: 1 of the frames cannot be made a solid: 3\n")
        << output;
    EXPECT_EQ(run("knot.rbn --frames 3: --thickness 0.001 --verify-only -o " + output).exit_code, 0)
        << output;
  }
}

TEST_F(Tool, a_motion_holds_the_frame_before_one_that_cannot_be_made_a_solid) {
  record(without_obstacle());
  const auto motion = run("knot.rbn -o knot.mdd --thickness 0.001");
  EXPECT_EQ(motion.exit_code, 1);
  EXPECT_THAT(motion.output, StartsWith("5 frames, 1 of them the same as another, 0.0 MB"));
  EXPECT_THAT(motion.errors, HasSubstr("1 of the frames cannot be made a solid: 3"));
  const std::string mdd = bytes("knot.mdd");
  const std::size_t begin = 8 + 5 * 4;
  const auto frame = [&](std::size_t index) {
    return mdd.substr(begin + index * 2 * sample_bytes, 2 * sample_bytes);
  };
  EXPECT_TRUE(frame(2) == frame(1));
  EXPECT_FALSE(frame(3) == frame(2));
}

TEST_F(Tool, where_no_frame_can_be_made_a_solid_the_conversion_fails) {
  for (const char* output : {"'out/{frame}.obj'", "out/knot.mdd"})
    expect_refusal(run(std::string("knot.rbn --frames 3 --thickness 0.001 -o ") + output),
                   "the cloth of no frame can be made a solid; leave --thickness out");
}

TEST_F(Tool, cloth_too_thin_for_its_coordinates_is_to_be_thicker) {
  SampleKnot knot = without_obstacle();
  for (auto& frame : knot.frames) frame *= 90;
  record(knot);
  for (const char* options : {"-o 'out/{frame}.obj'", "-o out/knot.mdd",
                              "-o out/knot.mdd --dry-run", "-o out/large.mdd --scale 1000"}) {
    const ToolRun thin = run(std::string("knot.rbn --frames 1 --thickness 1e-6 ") + options);
    EXPECT_EQ(thin.exit_code, 2) << options;
    const std::string remedy = "does not tell its sides apart; set --thickness to ";
    ASSERT_THAT(thin.errors, HasSubstr(remedy)) << options;
    const std::string told = thin.errors.substr(thin.errors.find(remedy) + remedy.size());
    EXPECT_EQ(
        run("knot.rbn --frames 1 --thickness " + told.substr(0, told.find(' ')) + " " + options)
            .exit_code,
        0)
        << options;
  }
}

class TexturedTool : public Tool {
 protected:
  TexturedTool() { EXPECT_TRUE(write_file(folder_ / "cloth.png", sample_png())); }

  [[nodiscard]] ToolRun convert_to(const std::string& output) const {
    return run("knot.rbn --texture cloth.png --quiet -o " + output);
  }
};

TEST_F(TexturedTool, the_picture_lies_beside_the_files_that_refer_to_it) {
  for (const char* output : {"'1/a.{frame}.obj'", "'2/a.{frame}.fbx'", "3/a.fbx", "4/a.mdd",
                             "5/a.usda", "'{frame}.folder/a.obj'"})
    EXPECT_EQ(output_of(convert_to(output)), "") << output;
  for (const char* folder : {"1", "2", "3", "4", "5", "0002.folder"})
    EXPECT_EQ(bytes(std::string(folder) + "/a.png"), sample_png()) << folder;
  EXPECT_THAT(bytes("4/a.mtl"), HasSubstr("map_Kd a.png\n"));
  EXPECT_THAT(bytes("5/a.usda"), HasSubstr("asset inputs:file = @./a.png@\n"));
}

TEST_F(TexturedTool, a_glb_holds_the_picture_itself) {
  EXPECT_EQ(output_of(convert_to("out/a.glb")), "");
  EXPECT_THAT(names("out"), ElementsAre("a.glb"));
}

TEST_F(TexturedTool, another_picture_is_not_replaced_unasked) {
  ASSERT_TRUE(write_file(folder_ / "a.png", "somebody's"));
  expect_refusal(convert_to("a.obj --frames 1"), "a.png: exists already");
  EXPECT_EQ(bytes("a.png"), "somebody's");
  EXPECT_EQ(convert_to("a.obj --frames 1 --force").exit_code, 0);
  EXPECT_EQ(bytes("a.png"), sample_png());
}

TEST_F(TexturedTool, a_picture_that_lies_there_already_stays_as_it_is) {
  fs::create_hard_link(folder_ / "cloth.png", folder_ / "a.png");
  EXPECT_EQ(convert_to("a.usda").exit_code, 0);
  EXPECT_TRUE(fs::equivalent(folder_ / "a.png", folder_ / "cloth.png"));
}

TEST_F(TexturedTool, formats_without_materials_refuse_it) {
  for (const char* output : {"a.abc", "a.npy", "a.csv", "a.rbn"})
    expect_refusal(convert_to(output), "file has no materials; leave --texture out");
  expect_refusal(convert_to("a.obj --object obstacle"), "leave --texture out");
}

TEST_F(TexturedTool, the_back_of_a_solid_can_show_another_picture) {
  record(without_obstacle());
  const std::string lining = sample_png() + "another";
  ASSERT_TRUE(write_file(folder_ / "lining.png", lining));
  const std::string both = " --texture-back lining.png --thickness 0.002 --frames 1,2 --verify";
  for (const std::string output :
       {"'1/a.{frame}.obj'", "'2/a.{frame}.fbx'", "3/a.fbx", "4/a.mdd", "5/a.usda", "6/a.glb"}) {
    EXPECT_EQ(output_of(convert_to(output + both)), "") << output;
    if (output == "6/a.glb") continue;  // it holds them
    const std::string below = output.substr(output[0] == '\'' ? 1 : 0, 2);
    EXPECT_EQ(bytes(below + "a.png"), sample_png()) << output;
    EXPECT_EQ(bytes(below + "a_back.png"), lining) << output;
  }
  EXPECT_THAT(bytes("5/a.usda"), HasSubstr("asset inputs:file = @./a_back.png@\n"));
}

TEST_F(TexturedTool, one_picture_never_replaces_the_other) {
  record(without_obstacle());
  const std::string lining = sample_png() + "another";
  ASSERT_TRUE(write_file(folder_ / "a.png", lining));
  expect_refusal(
      convert_to("a.obj --texture-back a.png --thickness 0.002 --frames 1 --force"),
      "a.png: is a picture that the ribbon shows, which would be lost; write to another folder");
  EXPECT_EQ(bytes("a.png"), lining);
}

TEST_F(TexturedTool, the_back_of_a_surface_cannot) {
  expect_refusal(convert_to("a.usda --texture-back cloth.png"),
                 "one surface, which shows one texture; add --thickness");
  expect_refusal(convert_to("a.abc --thickness 0.002 --texture-back cloth.png"), "--texture");
  expect_refusal(run("knot.rbn --texture-back cloth.png -o a.usda"), "--texture");
}

TEST_F(TexturedTool, a_texture_that_is_no_picture_is_refused_before_anything_is_written) {
  expect_refusal(run("knot.rbn --texture knot.rbn -o 'out/{frame}.obj'"),
                 "save the texture as PNG");
  expect_refusal(run("knot.rbn --texture none.png -o 'out/{frame}.obj'"), "none.png");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace ribbon::tool_test
