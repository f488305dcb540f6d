// The built ribbon-record, as a user meets it.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "commandline/tool_run.h"
#include "files/flipped.h"
#include "playback/frames_of.h"
#include "playback/recording_reader.h"
#include "recorder/process.h"
#include "recorder/small_scene.h"

namespace ribbon::tool_test {

namespace fs = std::filesystem;

// Until a recorder is at work on a recording that holds so many frames.
void wait_until_written(const fs::path& file, int frames, pid_t recorder) {
  const auto is_being_written = [&] {
    const auto reader = RecordingReader::open(file);
    return reader && reader->is_being_written() && reader->frame_count() >= frames;
  };
  while (!is_being_written()) {
    ASSERT_FALSE(has_ended(recorder));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

class RibbonRecord : public ToolTest {
 protected:
  RibbonRecord() : ToolTest(RIBBON_RECORD) { write_small_scene(folder_); }

  // As long.toml.
  void write_small_scene_lasting(const std::string& seconds) const {
    ASSERT_TRUE(write_file(folder_ / "long.toml", small_scene_text(seconds)).has_value());
  }
};

TEST_F(RibbonRecord, records_a_scene_and_sums_it_up_in_one_line) {
  const std::string answer = output_of(run("small.toml -o knot.rbn"));
  EXPECT_THAT(answer, StartsWith("knot.rbn: free start; 7 frames, 0.2 s in 24 steps"));
  EXPECT_EQ(std::count(answer.begin(), answer.end(), '\n'), 1);
  EXPECT_EQ(RecordingReader::open(folder_ / "knot.rbn").value().frame_count(), 7);
}

TEST_F(RibbonRecord, quiet_says_nothing) {
  EXPECT_EQ(output_of(run("small.toml -o knot.rbn --quiet")), "");
}

TEST_F(RibbonRecord, what_it_tells_of_a_recording_on_standard_output_goes_elsewhere) {
  ASSERT_EQ(run("small.toml -o knot.rbn --quiet").exit_code, 0);
  const std::string knot = bytes("knot.rbn");
  const ToolRun file = run("small.toml -o /dev/stdout --force --profile");
  const ToolRun pipe = run("small.toml -o /dev/stdout --profile 2> told | cat");
  EXPECT_TRUE(file.output == knot);
  EXPECT_TRUE(pipe.output == knot);
  for (const std::string& told : {file.errors, bytes("told")}) {
    EXPECT_THAT(told, HasSubstr("/dev/stdout: free start; 7 frames"));
    EXPECT_THAT(told, HasSubstr("a step, 24 times"));
  }
}

TEST_F(RibbonRecord, writes_the_figures_of_the_run) {
  ASSERT_EQ(run("small.toml -o knot.rbn --stats figures/run.json").exit_code, 0);
  const auto json = nlohmann::json::parse(bytes("figures/run.json"));
  EXPECT_EQ(json["frames"], 7);
  EXPECT_EQ(json["bytes"], fs::file_size(folder_ / "knot.rbn"));
}

// As one that came meanwhile: a way through a folder that is yet to be created leads to it.
TEST_F(RibbonRecord, a_file_that_is_met_only_in_the_end_is_not_replaced) {
  ASSERT_TRUE(write_file(folder_ / "theirs", "somebody else's").has_value());
  for (const std::string words : {"small.toml --crossings for-diagrams/../theirs",
                                  "small.toml -o knot.rbn --quiet --stats for-figures/../theirs"}) {
    expect_refusal(run(words), "theirs: was put there by somebody else");
    EXPECT_EQ(bytes("theirs"), "somebody else's");
  }
  EXPECT_EQ(RecordingReader::open(folder_ / "knot.rbn").value().frame_count(), 7);
}

TEST_F(RibbonRecord, what_is_to_be_replaced_stays_where_nothing_can_be_recorded) {
  ASSERT_EQ(run("small.toml -o knot.rbn --quiet").exit_code, 0);
  const std::string knot = bytes("knot.rbn");
  for (const char* words : {"small.toml -o knot.rbn --force", "small.toml -o new.rbn --force"})
    expect_refusal(run(words, "ulimit -f 1 &&"), ".rbn: cannot be written (File too large)");
  EXPECT_TRUE(bytes("knot.rbn") == knot);
  EXPECT_FALSE(fs::exists(folder_ / "new.rbn"));
}

TEST_F(RibbonRecord, figures_take_no_other_files_place) {
  ASSERT_EQ(run("small.toml -o knot.rbn --quiet --frames 3 --stats run.json").exit_code, 0);
  const std::string knot = bytes("knot.rbn");
  const std::string scene = bytes("small.toml");
  expect_refusal(run("small.toml -o other.rbn --stats run.json"),
                 "run.json: exists already; name another file after --stats");
  EXPECT_FALSE(fs::exists(folder_ / "other.rbn"));
  EXPECT_EQ(run("small.toml -o other.rbn --quiet --stats run.json --force").exit_code, 0);
  expect_refusal(run("--resume knot.rbn --stats run.json"), "run.json: exists already");
  for (const std::string words : {"--resume knot.rbn --stats ./knot.rbn --force",
                                  "--from 2 -o take.rbn knot.rbn --stats knot.rbn --force",
                                  "small.toml -o new.rbn --stats small.toml --force",
                                  "small.toml -o new.rbn --stats new.rbn"})
    expect_refusal(run(words), "in whose place figures cannot go");
  expect_refusal(run("small.toml -o new.rbn --stats knot.rbn --force"), "knot.rbn: is a recording");
  EXPECT_TRUE(bytes("knot.rbn") == knot);
  EXPECT_TRUE(bytes("small.toml") == scene);
  EXPECT_FALSE(fs::exists(folder_ / "new.rbn"));
  EXPECT_EQ(run("--resume knot.rbn --quiet --stats run.json --force").exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(bytes("run.json"))["frames"], 7);
}

TEST_F(RibbonRecord, a_place_where_no_figures_can_go_is_told_before_the_run) {
  fs::create_directory(folder_ / "figures");
  for (const std::string place : {"figures", "figures --force", "small.toml/run.json"})
    expect_refusal(run("small.toml -o knot.rbn --stats " + place), "");
  EXPECT_THAT(run("small.toml -o knot.rbn --stats figures").errors, HasSubstr("is a folder"));
  EXPECT_FALSE(fs::exists(folder_ / "knot.rbn"));
}

TEST_F(RibbonRecord, a_limit_that_no_run_reaches_is_told_by_its_name) {
  for (const std::string limit : {"--until 1000000000", "--frames 1000000000"})
    expect_refusal(run("small.toml -o knot.rbn " + limit), limit + ": 'duration' is ");
}

// Whatever part of it finds none, on whatever thread.
TEST_F(RibbonRecord, without_memory_it_ends_with_a_sentence) {
  if (run("--version", "ulimit -v 8000000;").exit_code != 0) GTEST_SKIP() << "sanitizers need more";
  int refused = 0;
  for (int kilobytes = 40'000; kilobytes <= 64'000; kilobytes += 1'000) {
    const ToolRun limited =
        run("small.toml --quiet --force -o knot.rbn --set ribbon.along=400 --set ribbon.across=16 "
            "--frames 4",
            "ulimit -v " + std::to_string(kilobytes) + ";");
    if (limited.exit_code == 0 || limited.exit_code == 127) continue;  // 127: not even loaded
    EXPECT_EQ(limited.exit_code, 2) << kilobytes;
    EXPECT_THAT(limited.errors,
                testing::AnyOf(HasSubstr("not enough memory"), HasSubstr("no more threads")))
        << kilobytes;
    ++refused;
  }
  EXPECT_GT(refused, 0);
}

TEST_F(RibbonRecord, nothing_takes_the_place_of_a_file_of_the_scene) {
  const std::string drawing = line_to("300");
  ASSERT_TRUE(write_file(folder_ / "line.svg", drawing).has_value());
  const std::string mesh = read_file(write_square_post(folder_)).value();
  const std::string scene =
      drawn_in_a_file(small_scene_text()) + "\n[obstacle]\nmesh = 'post.obj'\n";
  ASSERT_TRUE(write_file(folder_ / "drawn.toml", scene).has_value());
  fs::create_symlink("drawn.toml", folder_ / "link.rbn");
  for (const std::string words :
       {"-o drawn.toml", "-o ./line.svg", "-o post.obj", "-o link.rbn", "--crossings line.svg",
        "--draw -o drawn.toml", "-o new.rbn --stats post.obj"})
    expect_refusal(run("drawn.toml --force " + words),
                   "is a file of the scene, which would be lost");
  EXPECT_TRUE(bytes("drawn.toml") == scene);
  EXPECT_TRUE(bytes("line.svg") == drawing);
  EXPECT_TRUE(bytes("post.obj") == mesh);
  EXPECT_FALSE(fs::exists(folder_ / "new.rbn"));
}

TEST_F(RibbonRecord, a_folder_is_no_place_for_a_recording) {
  fs::create_directory(folder_ / "knots");
  for (const std::string words : {"-o knots", "-o knots/ --force"})
    expect_refusal(run("small.toml " + words), ": is a folder; name a file after -o");
}

TEST_F(RibbonRecord, a_disk_without_any_room_leaves_nothing_in_the_way) {
  const ToolRun limited = run("small.toml -o knot.rbn", "ulimit -f 0;");
  EXPECT_NE(limited.exit_code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "knot.rbn"));
  EXPECT_EQ(run("small.toml -o knot.rbn").exit_code, 0);
}

TEST_F(RibbonRecord, a_run_that_goes_on_tells_of_lost_frames) {
  write_small_scene_lasting("4");
  ASSERT_EQ(run("long.toml -o knot.rbn --quiet --frames 100").exit_code, 0);
  const std::string whole = bytes("knot.rbn");
  ASSERT_TRUE(write_file(folder_ / "knot.rbn", flipped(whole, whole.size() / 2)).has_value());
  const auto answer = run("--resume knot.rbn --frames 102 --quiet");
  EXPECT_EQ(answer.exit_code, 0);
  EXPECT_THAT(answer.errors, StartsWith("ribbon-record: knot.rbn: frames "));
  EXPECT_THAT(answer.errors, HasSubstr(" are lost; record the scene anew"));
}

TEST_F(RibbonRecord, the_number_of_threads_changes_nothing) {
  ASSERT_EQ(run("small.toml -o one.rbn --threads 1").exit_code, 0);
  ASSERT_EQ(run("small.toml -o two.rbn --threads 2").exit_code, 0);
  EXPECT_TRUE(bytes("one.rbn") == bytes("two.rbn"));
}

TEST_F(RibbonRecord, ctrl_c_and_a_closed_terminal_leave_a_valid_recording) {
  write_small_scene_lasting("600");
  for (const int signal : {SIGINT, SIGHUP}) {
    const pid_t recorder =
        spawned({"/bin/sh", "-c",
                 "cd '" + folder_.string() +
                     "' && exec '" RIBBON_RECORD "' long.toml --force -o knot.rbn > output.txt"});
    wait_until_written(folder_ / "knot.rbn", 3, recorder);
    ::kill(recorder, signal);
    EXPECT_EQ(waited_for(recorder), 3);
    EXPECT_THAT(bytes("output.txt"), HasSubstr("ended early by the user"));
    EXPECT_TRUE(RecordingReader::open(folder_ / "knot.rbn")->finished());
    fs::remove(folder_ / "knot.rbn");
  }
}

TEST_F(RibbonRecord, a_limit_that_is_reached_is_no_early_end) {
  for (const std::string limit : {"--until 0.1", "--frames 4"})
    EXPECT_THAT(output_of(run("small.toml --force -o knot.rbn " + limit)),
                EndsWith("; ended at 0.1 s, as asked\n"));
}

TEST_F(RibbonRecord, an_older_recording_is_replaced_by_force_alone) {
  ASSERT_EQ(run("small.toml -o knot.rbn --quiet").exit_code, 0);
  ASSERT_EQ(run("small.toml -o older.rbn --quiet --frames 3").exit_code, 0);
  const std::string older = bytes("older.rbn");
  for (const std::string words : {"small.toml", "--from 3 knot.rbn"}) {
    expect_refusal(run(words + " -o older.rbn"),
                   "older.rbn: exists already; go on with that "
                   "recording by --resume, replace it by --force");
    EXPECT_TRUE(bytes("older.rbn") == older);
    EXPECT_EQ(run(words + " -o older.rbn --force").exit_code, 0);
    EXPECT_EQ(RecordingReader::open(folder_ / "older.rbn")->frame_count(), 7);
    ASSERT_TRUE(write_file(folder_ / "older.rbn", older).has_value());
  }
  // What cannot even begin leaves it as it is.
  expect_refusal(run("small.toml --force --set ribbon.width=50 -o older.rbn"), "ribbon.width");
  EXPECT_TRUE(bytes("older.rbn") == older);
  EXPECT_EQ(run("small.toml -o /dev/null --quiet").exit_code, 0) << "which holds nothing";
}

TEST_F(RibbonRecord, settings_change_a_scene_as_if_they_stood_in_it) {
  const std::string settings = " --set fastening.speed=1 --set accuracy=fine";
  ASSERT_EQ(run("small.toml -o knot.rbn --quiet" + settings).exit_code, 0);
  std::string text = "accuracy = \"fine\"\n" + small_scene_text();
  text.replace(text.find("speed = 0.2"), 11, "speed = 1");
  ASSERT_TRUE(write_file(folder_ / "fine.toml", text).has_value());
  ASSERT_EQ(run("fine.toml -o fine.rbn --quiet").exit_code, 0);
  EXPECT_EQ(frames_of(folder_ / "knot.rbn"), frames_of(folder_ / "fine.rbn"));
  const auto reader = RecordingReader::open(folder_ / "knot.rbn").value();
  EXPECT_EQ(reader.header().scene_text, text);
  ASSERT_EQ(reader.sessions().size(), 1U);
  EXPECT_EQ(reader.sessions()[0], (Session{0,
                                           {SessionReason::begun, "ribbon-record " RIBBON_VERSION,
                                            "fastening.speed=1\naccuracy=fine\n"}}));
  EXPECT_TRUE(RecordingReader::open(folder_ / "fine.rbn")->sessions().empty());
  ASSERT_EQ(run("--resume knot.rbn --until 0.3 --quiet").exit_code, 0);
  expect_refusal(run("small.toml -o new.rbn --set fastening.spede=1"),
                 "small.toml with 'fastening.spede=1': unknown key 'spede' in [fastening]; did you "
                 "mean 'speed'?");
  expect_refusal(run("small.toml -o new.rbn --set fastening.spede=1 --set ribbon.widht=1"),
                 "small.toml with 'fastening.spede=1': unknown key 'spede' in [fastening]");
  expect_refusal(run("small.toml -o new.rbn --set ribbon.width=-1"), "'width' must be a number");
  EXPECT_FALSE(fs::exists(folder_ / "new.rbn"));
}

// The drawing and the mesh stand beside the scene, wherever the recorder is started.
TEST_F(RibbonRecord, a_run_beyond_its_scene_finds_its_files) {
  fs::create_directories(folder_ / "scenes");
  ASSERT_TRUE(write_file(folder_ / "scenes/line.svg", line_to("300")));
  ASSERT_TRUE(write_file(folder_ / "scenes/line.toml", drawn_in_a_file(small_scene_text())));
  ASSERT_EQ(run("scenes/line.toml -o line.rbn --frames 9 --quiet").exit_code, 0);
  EXPECT_EQ(RecordingReader::open(folder_ / "line.rbn")->frame_count(), 9);
  fs::remove(folder_ / "scenes/line.svg");
  expect_refusal(run("scenes/line.toml -o new.rbn"),
                 "scenes/line.toml:3:7: 'scenes/line.svg' "
                 "does not exist");
  const std::string with_post = small_scene_text() + "[obstacle]\nmesh = 'post.obj'\n";
  ASSERT_TRUE(write_file(folder_ / "posts.toml", with_post));
  expect_refusal(run("posts.toml -o new.rbn"), "posts.toml:24:8: 'post.obj' does not exist");
}

TEST_F(RibbonRecord, a_mistake_in_the_scene_is_told_with_its_place) {
  ASSERT_TRUE(write_file(folder_ / "wrong.toml", small_scene_text() + "widht = 1\n").has_value());
  expect_refusal(run("wrong.toml -o knot.rbn"), "wrong.toml:");
  EXPECT_FALSE(fs::exists(folder_ / "knot.rbn"));
}

TEST_F(RibbonRecord, what_cannot_be_read_or_written_is_named) {
  expect_refusal(run("missing.toml -o knot.rbn"), "missing.toml");
  expect_refusal(run("small.toml -o /proc/knot.rbn"), "/proc/knot.rbn");
  expect_refusal(run("small.toml"), "--output");
}

TEST_F(RibbonRecord, a_recording_in_the_place_of_a_scene_is_told_with_what_can_be_done) {
  ASSERT_EQ(run("small.toml -o knot.rbn --quiet").exit_code, 0);
  expect_refusal(run("knot.rbn -o other.rbn"),
                 "knot.rbn: is a recording, not a scene; go on with it by --resume");
  expect_refusal(run("knot.rbn --set fastening.speed=1 -o other.rbn"), "--from");
  expect_refusal(run("knot.rbn --crossings numbered.svg"), "is a recording, not a scene");
  expect_refusal(run("knot.rbn --draw -o sketch.html"), "is a recording, not a scene");
  EXPECT_FALSE(fs::exists(folder_ / "other.rbn"));
}

TEST_F(RibbonRecord, shows_the_crossings_of_a_drawing_and_which_knot_it_is) {
  EXPECT_THAT(output_of(run("small.toml --crossings small.svg")),
              AllOf(HasSubstr("crossings = \"OU\""), HasSubstr("Gauss code: O1"),
                    HasSubstr("knot: unknot")));
  EXPECT_THAT(read_file(folder_ / "small.svg").value(), HasSubstr(">2</text>"));
  expect_refusal(run("small.toml --crossings small.svg"), "exists already");
  EXPECT_THAT(output_of(run("small.toml --crossings small.svg --force --set "
                            "curve.crossings=\\\"UO\\\"")),
              HasSubstr("crossings = \"UO\""));
  expect_refusal(run("small.toml --crossings other.svg -o knot.rbn"), "records nothing");
  expect_refusal(run("small.toml --crossings other.svg --frames 3"), "leave them out");
  EXPECT_FALSE(fs::exists(folder_ / "other.svg"));
}

TEST_F(RibbonRecord, numbers_the_passages_of_a_drawing_whose_list_is_wrong) {
  const ToolRun run_with_wrong_list =
      run(R"(small.toml --crossings small.svg --set curve.crossings=\"UOU\")");
  expect_refusal(run_with_wrong_list, "the drawing has 2 passages");
  expect_refusal(run_with_wrong_list, "small.svg' shows the passages with their numbers");
  EXPECT_THAT(read_file(folder_ / "small.svg").value(), HasSubstr(">2</text>"));
}

TEST_F(RibbonRecord, what_does_not_go_together_is_told) {
  ASSERT_EQ(run("small.toml -o knot.rbn --quiet").exit_code, 0);
  expect_refusal(run(""), "no scene to record");
  expect_refusal(run("--resume knot.rbn -o other.rbn"), "--output names another one");
  expect_refusal(run("--resume knot.rbn small.toml"), "takes the scene from the recording");
  expect_refusal(run("--resume knot.rbn --from 3"), "cannot go together");
  expect_refusal(run("--resume knot.rbn --set fastening.speed=1"), "with the settings that");
  expect_refusal(run("--resume knot.rbn --force"), "leave --force out");
  expect_refusal(run("--from 3 -o other.rbn"), "name it at the end");
  expect_refusal(run("--from 3 knot.rbn"), "--output is required");
  expect_refusal(run("--from 0 -o other.rbn knot.rbn"), "--from");
  expect_refusal(run("--from 8 -o other.rbn knot.rbn"), "name one from 1 to 7");
  expect_refusal(run("--from 3 -o knot.rbn knot.rbn"), "its own recording");
  expect_refusal(run("--resume knot.rbn --until 1 --frames 4"), "--");
  expect_refusal(run("--resume knot.rbn --frames 4"), "7 frames already");
  expect_refusal(run("--resume knot.rbn --until -1"), "--until");
  expect_refusal(run("--from 3 --set fastening.spede=1 -o other.rbn knot.rbn"),
                 "did you mean 'speed'?");
  EXPECT_FALSE(fs::exists(folder_ / "other.rbn"));
}

TEST_F(RibbonRecord, resumes_extends_and_branches) {
  ASSERT_EQ(run("small.toml -o whole.rbn --quiet").exit_code, 0);
  ASSERT_EQ(run("small.toml -o knot.rbn --frames 3").exit_code, 0);
  EXPECT_THAT(output_of(run("--resume knot.rbn")),
              StartsWith("knot.rbn: free start; 7 frames, 0.2 s in 24 steps"));
  EXPECT_EQ(frames_of(folder_ / "knot.rbn"), frames_of(folder_ / "whole.rbn"));
  EXPECT_THAT(output_of(run("--resume knot.rbn")), HasSubstr("nothing to add"));
  EXPECT_EQ(run("--resume knot.rbn --until 0.3 --quiet").output, "");
  EXPECT_EQ(RecordingReader::open(folder_ / "knot.rbn")->frame_count(), 10);
  ASSERT_EQ(run("--from 5 --set fastening.speed=1 --set time.duration=0.5 -o fast.rbn knot.rbn")
                .exit_code,
            0);
  EXPECT_EQ(RecordingReader::open(folder_ / "fast.rbn")->frame_count(), 16);
}

TEST_F(RibbonRecord, a_recording_is_written_by_one_at_a_time) {
  write_small_scene_lasting("600");
  const std::string scene = folder_ / "long.toml";
  const std::string file = folder_ / "knot.rbn";
  // A new run, and then one that goes on with it.
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{RIBBON_RECORD, scene, "-o", file, "--quiet"},
        std::vector<std::string>{RIBBON_RECORD, "--resume", file, "--quiet"}}) {
    const pid_t first = spawned(words);
    ASSERT_GT(first, 0);
    wait_until_written(file, 1, first);
    const ToolRun resumed = run("--resume knot.rbn");
    const ToolRun replaced = run("long.toml -o knot.rbn --force");
    ::kill(first, SIGKILL);
    EXPECT_EQ(waited_for(first), -1);
    expect_refusal(resumed, "knot.rbn");
    expect_refusal(replaced, "knot.rbn");
    EXPECT_GT(RecordingReader::open(file)->frame_count(), 0);
  }
}

TEST_F(RibbonRecord, a_disk_that_fills_while_it_resumes_keeps_all_before) {
  write_small_scene_lasting("2");
  ASSERT_EQ(run("long.toml -o whole.rbn --quiet").exit_code, 0);
  ASSERT_EQ(run("long.toml -o knot.rbn --quiet --frames 8").exit_code, 0);
  const auto kilobytes = fs::file_size(folder_ / "knot.rbn") / 1024 + 8;
  expect_refusal(
      run("--resume knot.rbn", "ulimit -f " + std::to_string(kilobytes) + "; trap '' XFSZ;"),
      "knot.rbn");
  const auto whole = frames_of(folder_ / "whole.rbn");
  const auto kept = frames_of(folder_ / "knot.rbn");
  EXPECT_GE(kept.size(), 8U);
  EXPECT_LT(kept.size(), whole.size());
  EXPECT_EQ(first_difference(kept, whole), -1);
  ASSERT_EQ(run("--resume knot.rbn --quiet").exit_code, 0);
  EXPECT_EQ(frames_of(folder_ / "knot.rbn"), whole);
}

TEST_F(RibbonRecord, a_full_disk_keeps_the_frames_before_it) {
  const ToolRun answer = run("small.toml -o knot.rbn", "ulimit -f 16;");
  expect_refusal(answer, "knot.rbn");
  const auto reader = RecordingReader::open(folder_ / "knot.rbn");
  ASSERT_TRUE(reader.has_value()) << reader.error().sentence();
  EXPECT_GT(reader->frame_count(), 0);
  EXPECT_LT(reader->frame_count(), 7);
}

TEST_F(RibbonRecord, help_shows_examples_and_version_the_version) {
  EXPECT_THAT(output_of(run("--help")), HasSubstr("Examples:"));
  EXPECT_EQ(run("--version").output, "ribbon-record " RIBBON_VERSION "\n");
}

}  // namespace ribbon::tool_test
