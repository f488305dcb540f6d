// Runs in stages: what their recordings tell, how they go on and branch off.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "playback/frames_of.h"
#include "recorder/branch.h"
#include "recorder/record.h"
#include "recorder/resume.h"
#include "recorder/small_scene.h"
#include "recorder/test_runs.h"
#include "recording/writer/recording_writer.h"
#include "result/refusal.h"
#include "scene/scene.h"

namespace ribbon::stages_test {

namespace fs = std::filesystem;

std::string staged_scene_text(const std::string& first_hand_at = "[0, 0.1]") {
  return small_scene_text("2") +
         "checkpoint_every = 0.5\n"
         "[[stage]]\nname = 'half knot'\nuntil = 0.5\nfriction = 0.5\n"
         "[[stage.hand]]\nat = " +
         first_hand_at +
         "\npull = [-1, 0, 0]\n"
         "[[stage.hand]]\nat = [0.9, 1]\nhold = true\n"
         "[[stage]]\nname = 'tails'\nuntil = 1\n"
         "[[stage.hand]]\nat = [0.8, 1]\npull = 'along'\n";
}

class Stages : public TestInFolder {
 protected:
  [[nodiscard]] Result<RunStatistics> recorded(const std::vector<std::string>& settings = {},
                                               const std::string& text = staged_scene_text(),
                                               const RunLimit& limit = {}) const {
    (void)write_file(folder_ / "knot.toml", text);
    return read_scene(folder_ / "knot.toml", settings).and_then([&](const Scene& scene) {
      return record(scene, replacing(file()), goes_on, limit);
    });
  }
  [[nodiscard]] fs::path file() const { return folder_ / "knot.rbn"; }
  [[nodiscard]] fs::path take() const { return folder_ / "take.rbn"; }

  // How many frames lie in each of the header's two stages.
  static std::array<int, 3> frames_in_stages(const fs::path& file) {
    const auto reader = RecordingReader::open(file).value();
    std::array<int, 3> counts{};
    for (int frame = 0; frame < reader.frame_count(); ++frame)
      ++counts.at(reader.numbers(frame)->stage);
    return counts;
  }
};

// By hand: 30 frames a second, the start among them.
TEST_F(Stages, frames_know_theirs_and_the_header_their_names) {
  ASSERT_EQ(refusal_of(recorded()), "");
  EXPECT_EQ(RecordingReader::open(file())->header().stages,
            (std::vector<std::string>{"half knot", "tails"}));
  EXPECT_EQ(frames_in_stages(file()), (std::array{15, 16, 30})) << "they are over after 1.5 s";
  EXPECT_EQ(RecordingReader::open(file())->numbers(60)->stage, 0);
}

TEST_F(Stages, until_tight_ends_the_run_when_all_are_over) {
  EXPECT_EQ(recorded({"time.until=tight"})->ending, RunEnding::stages_over);
  EXPECT_EQ(frames_in_stages(file()), (std::array{0, 16, 30}));
  EXPECT_EQ(RecordingReader::open(file())->ending(), RunEnding::stages_over);
  EXPECT_FALSE(resume(file(), "test", goes_on)->has_value()) << "there is nothing to add";
}

TEST_F(Stages, a_run_that_was_cut_short_goes_on_to_the_same_bits) {
  ASSERT_EQ(refusal_of(recorded()), "");
  const auto whole = frames_of(file());
  for (const int frames : {8, 15, 17, 30, 50}) {
    ASSERT_EQ(refusal_of(recorded({}, staged_scene_text(), {.frames = frames})), "");
    ASSERT_TRUE(resume(file(), "test", goes_on).has_value());
    EXPECT_EQ(first_difference(frames_of(file()), whole), -1) << frames;
  }
}

TEST_F(Stages, that_do_not_reach_their_goal_in_time_are_named) {
  EXPECT_TRUE(recorded()->stages_given_up.empty()) << "they were to last so long";
  const std::vector<std::string> at_most{"stage[1].until=tight", "stage[1].at_most=0.3"};
  const auto done = recorded(at_most);
  ASSERT_EQ(refusal_of(done), "");
  EXPECT_EQ(done->stages_given_up, std::vector<std::string>{"half knot"});
  EXPECT_THAT(summary_line(*done),
              testing::HasSubstr("; 'at_most' ended 'half knot' before its goal was reached"));
  // Also by the run that goes on behind that.
  ASSERT_EQ(refusal_of(recorded(at_most, staged_scene_text(), {.frames = 30})), "");
  EXPECT_EQ(resume(file(), "test", goes_on)->value().stages_given_up,
            std::vector<std::string>{"half knot"});
}

// As it was before 0.2: all frames behind the last stage bore its number.
TEST_F(Stages, an_older_recording_goes_on_to_the_same_bits) {
  ASSERT_EQ(refusal_of(recorded()), "");
  const auto whole = frames_of(file());
  const RecordingHeader header = RecordingReader::open(file())->header();
  {
    auto writer = RecordingWriter::create(file(), header).value();
    for (int frame = 0; frame < 55; ++frame) {
      FrameNumbers numbers = *whole[frame].numbers;
      if (numbers.stage == 0) numbers.stage = 2;
      ASSERT_TRUE(writer.append(numbers, whole[frame].positions.cast<double>()).has_value());
    }
  }
  ASSERT_EQ(refusal_of(resume(file(), "test", goes_on)), "");
  EXPECT_EQ(frames_in_stages(file()), (std::array{6, 16, 39}));
  EXPECT_EQ(frames_of(file()).back().positions, whole.back().positions);
}

// 1.21 s lie between two frames.
TEST_F(Stages, that_end_between_two_frames_are_not_told_of_the_later_one) {
  ASSERT_EQ(refusal_of(recorded({"stage[2].until=0.71"})), "");
  EXPECT_EQ(frames_in_stages(file()), (std::array{24, 16, 21}));
}

TEST_F(Stages, a_take_can_time_them_anew) {
  ASSERT_EQ(refusal_of(recorded()), "");
  const auto taken = [&](int frame, const std::string& setting) {
    return refusal_of(
        branch(file(), frame, {take(), "brancher", {setting}, Overwrite::yes}, goes_on));
  };
  ASSERT_EQ(taken(9, "stage[1].until=0.8"), "");
  EXPECT_EQ(frames_in_stages(take()), (std::array{6, 25, 30}));
  const auto whole = frames_of(file());
  const auto longer = frames_of(take());
  EXPECT_EQ(longer[15].positions, whole[15].positions) << "tightness is measured anew, no more";
  EXPECT_NE(longer[16].positions, whole[16].positions);
  ASSERT_EQ(taken(9, "stage[1].until=0.1"), "");
  EXPECT_EQ(frames_in_stages(take()), (std::array{21, 10, 30})) << "its time is over already";
  ASSERT_EQ(taken(9, "stage[1].hand[2].at=[0.8, 1]"), "");
  EXPECT_EQ(first_difference(frames_of(take()), frames_of(file())), 10);
  EXPECT_THAT(taken(9, "stage[3].until=1"), HasSubstr("there is no 'stage[3]'"));
  EXPECT_THAT(taken(9, "stage[2].hand[1].at=tip"), HasSubstr("the drawing is a list of points"));
}

// A half knot round a post, drawn by one end, until the other tail is used up.
std::string one_sided_scene_text() {
  const std::string samples = RIBBON_SAMPLES;
  return "[curve]\nsvg = '" + samples +
         "/overhand-hourglass.svg'\nunit = 0.0006\n"
         "[ribbon]\nwidth = 0.05\nalong = 160\nacross = 4\nmass = 0.1\n"
         "[springs]\nstretch = 10\nshear = 10\nbend = 10\n[air]\nresistance = 10\n"
         "[obstacle]\nmesh = '" +
         samples +
         "/cylinder.obj'\nscale = 0.5\n"
         "[fastening]\nspeed = 1\n"
         "[[stage]]\n[[stage.hand]]\nat = [0.97, 1]\npull = [1, 0, 0]\n"
         "[time]\nduration = 10\n[recording]\nframes_per_second = 10\n";
}

TEST_F(Stages, an_end_that_is_about_to_slip_ends_the_run_with_the_advice) {
  const auto done = recorded({}, one_sided_scene_text());
  ASSERT_EQ(refusal_of(done), "");
  EXPECT_EQ(done->ending, RunEnding::first_end_slips);
  EXPECT_LT(done->frames, 101);
  EXPECT_THAT(summary_line(*done), HasSubstr("the first end would slip out of its knot; draw a "
                                             "longer tail, or hold it"));
  EXPECT_EQ(RecordingReader::open(file())->ending(), RunEnding::first_end_slips);
  EXPECT_FALSE(resume(file(), "test", goes_on, {.until_s = 12})->has_value());
  EXPECT_THAT(nothing_to_add(file()), HasSubstr("branch off before that by --from"));
}

// The second end is carried over to the first, near which the band then touches itself.
TEST_F(Stages, an_end_that_a_hand_holds_does_not_slip) {
  const auto done =
      recorded({},
               "[curve]\npoints = [[-500, 0], [-250, 0], [0, 0], [250, 0], [500, 0]]\naxis = 'z'\n"
               "[ribbon]\nwidth = 0.05\nalong = 80\nacross = 5\nmass = 0.02\n"
               "[springs]\nstretch = 1000\nshear = 1000\nbend = 100\n[air]\nresistance = 4\n"
               "[fastening]\nspeed = 1\n"
               "[[stage]]\nuntil = 'carried'\n"
               "[[stage.hand]]\nat = [0.97, 1]\nspeed = 2\n"
               "carry = [[500, 0], [450, -200], [-300, -100], [-300, -10], [-600, -10]]\n"
               "[[stage.hand]]\nat = [0, 0.1]\nhold = true\nspeed = 5\n"
               "[time]\nduration = 1.5\n[recording]\nframes_per_second = 10\n");
  ASSERT_EQ(refusal_of(done), "");
  EXPECT_EQ(done->ending, RunEnding::duration);
  EXPECT_EQ(done->frames, 16);
}

// A band that is held at one end and pulled at the other is tight after two seconds; then it is let
// go, and a take leaves it so, unless other hands come.
TEST_F(Stages, hands_that_let_go_do_not_grip_again_in_a_take_unless_they_change) {
  const std::string text =
      "[curve]\npoints = [[-500, 0], [0, 0], [500, 0]]\n"
      "[ribbon]\nwidth = 0.05\nalong = 40\nacross = 3\nmass = 0.02\n"
      "[springs]\nstretch = 100\nshear = 100\nbend = 10\n[air]\nresistance = 4\n"
      "[fastening]\nspeed = 0.1\n"
      "[[stage]]\n[[stage.hand]]\nat = [0, 0.1]\nhold = true\n"
      "[[stage.hand]]\nat = [0.9, 1]\npull = [1, 0, 0]\n"
      "[time]\nduration = 4\n[recording]\nframes_per_second = 10\n";
  const auto done = recorded({}, text);
  ASSERT_EQ(refusal_of(done), "");
  const auto last_stage_of_take = [&](const std::vector<std::string>& settings) {
    const NewRecording taken{
        .file = take(), .program = "test", .settings = settings, .overwrite = Overwrite::yes};
    EXPECT_EQ(refusal_of(branch(file(), 35, taken, goes_on)), "");
    return RecordingReader::open(take())->numbers(40)->stage;
  };
  ASSERT_EQ(RecordingReader::open(file())->numbers(35)->stage, 0);
  for (const std::string other : {"friction.coefficient=0.1", "stage[1].friction=0.3",
                                  "stage[1].name=anything", "stage[1].at_most=50"})
    EXPECT_EQ(last_stage_of_take({other}), 0) << other;
  EXPECT_EQ(last_stage_of_take({"stage[1].hand[2].speed=0.2"}), 1);
}

std::string drawing_with_marks() {
  return "<svg xmlns='http://www.w3.org/2000/svg'><path id='band' d='M -300 0 L 300 0'/>"
         "<g transform='translate(100 0)'><circle id='middle' cx='-100' cy='5' r='4'/></g>"
         "<circle id='tip' cx='-310' cy='0' r='4'/><circle cx='1' cy='1' r='1'/></svg>";
}

TEST_F(Stages, marks_are_found_in_the_drawing_and_told_as_spans) {
  (void)write_file(folder_ / "line.svg", drawing_with_marks());
  const auto span_of = [&](const std::string& id) -> Span {
    const auto done =
        recorded({}, drawn_in_a_file(staged_scene_text("'" + id + "'")), {.frames = 3});
    EXPECT_EQ(refusal_of(done), "");
    const auto reader = RecordingReader::open(file()).value();
    return std::get<Span>(read_scene(file(), reader.header().scene_text)->stages[0].hands[0].at);
  };
  // The line is 0.6 m long, the band 3 cm wide, its rows a 59th of the length apart.
  EXPECT_NEAR(span_of("middle").begin, 0.5 - 0.025, 0.5 / 59 + 1e-9);
  EXPECT_NEAR(span_of("middle").end - span_of("middle").begin, 0.05, 1e-9);
  EXPECT_EQ(span_of("tip").begin, 0);
  EXPECT_NEAR(span_of("tip").end, 0.025, 1e-9);
  fs::remove(folder_ / "line.svg");
  EXPECT_TRUE(resume(file(), "test", goes_on)->has_value()) << "without its drawing";
}

// As only a forged one does.
TEST_F(Stages, a_recording_that_names_marks_is_not_gone_on_with) {
  (void)recorded({}, staged_scene_text(), {.frames = 3}).value();
  auto header = RecordingReader::open(file())->header();
  header.scene_text = staged_scene_text("'tip'");
  ASSERT_TRUE(RecordingWriter::create(file(), header, Overwrite::when_told)->finish());
  EXPECT_THAT(refusal_of(resume(file(), "test", goes_on)),
              HasSubstr("its scene still names marks of a drawing"));
}

TEST_F(Stages, the_header_tells_marks_and_the_part_whose_knot_is_certified) {
  (void)write_file(folder_ / "line.svg", drawing_with_marks());
  const std::string text = drawn_in_a_file(staged_scene_text()) +
                           "[knot]\nexpect = 'unknot'\nbetween = ['middle', 'tip']\n"
                           "expect_between = 'unknot'\n";
  ASSERT_EQ(refusal_of(recorded({}, text, {.frames = 3})), "");
  const auto told = [](const fs::path& file) { return RecordingReader::open(file)->header(); };
  const RecordingHeader header = told(file());
  ASSERT_EQ(header.marks.size(), 2U);
  EXPECT_EQ(header.marks[0].name, "middle");
  EXPECT_NEAR(header.marks[0].share, 0.5, 0.5 / 59 + 1e-9);
  EXPECT_EQ(header.marks[1], (RecordedMark{"tip", 0}));
  EXPECT_EQ(header.knot_between, (KnotBetween{{header.marks[0].share, 0}, "unknot"}));
  fs::remove(folder_ / "line.svg");
  ASSERT_EQ(refusal_of(branch(file(), 1, {take(), "brancher", {}}, goes_on)), "");
  EXPECT_EQ(told(take()).knot_between, header.knot_between);
  EXPECT_THAT(
      refusal_of(branch(file(), 1, {take(), "brancher", {"knot.between=[0, 0.5]"}, Overwrite::yes},
                        goes_on)),
      HasSubstr("[knot] cannot change in a branch"));
}

// A band of 60 cm, and a path on which its first end is carried inwards.
std::string drawing_with_a_path() {
  return "<svg xmlns='http://www.w3.org/2000/svg'><path id='band' d='M -300 0 L 300 0'/>"
         "<g transform='translate(0 -100)'><path id='round' d='M -200 100 L -150 0 L -100 0'/></g>"
         "<circle id='tip' cx='-310' cy='0' r='4'/></svg>";
}

std::string carrying_scene_text(const std::string& path = "round") {
  std::string text = drawn_in_a_file(small_scene_text("3"));
  return text.insert(text.find("[ribbon]"), "path = 'band'\n") +
         "checkpoint_every = 0.5\n"
         "[[stage]]\nuntil = 'carried'\n"
         "[[stage.hand]]\nat = 'tip'\ncarry = '" +
         path +
         "'\nheight = [[0, 0], [0.5, 0.2], [1, 0]]\nspeed = 0.4\n"
         "[[stage.hand]]\nat = [0.9, 1]\nhold = true\n"
         "[[stage]]\nuntil = 0.2\n[[stage.hand]]\nat = [0.9, 1]\nhold = true\n";
}

Eigen::Vector3f middle_of_first_rows(const PlayedFrame& frame) {
  return frame.positions.leftCols(2 * 4).rowwise().mean();
}

TEST_F(Stages, an_end_is_carried_to_where_it_was_drawn) {
  (void)write_file(folder_ / "line.svg", drawing_with_a_path());
  const auto done = recorded({"time.until=tight"}, carrying_scene_text());
  ASSERT_EQ(refusal_of(done), "");
  EXPECT_EQ(done->ending, RunEnding::stages_over);
  const auto frames = frames_of(file());
  const int arrived = frames_in_stages(file())[1] - 1;
  const auto at = [&](int frame) { return middle_of_first_rows(frames[frame]); };
  EXPECT_LT((at(arrived) - Eigen::Vector3f(-0.1F, 0, -0.1F)).norm(), 0.04F)
      << "a little behind what draws it";
  float highest_m = 0;
  for (int frame = 0; frame <= arrived; ++frame) highest_m = std::max(highest_m, at(frame).y());
  EXPECT_NEAR(highest_m, 0.2F, 0.02F);
}

TEST_F(Stages, what_is_carried_goes_on_to_the_same_bits_without_its_drawing) {
  (void)write_file(folder_ / "line.svg", drawing_with_a_path());
  ASSERT_EQ(refusal_of(recorded({}, carrying_scene_text())), "");
  const auto whole = frames_of(file());
  for (const int frames : {8, 30, 50}) {
    (void)write_file(folder_ / "line.svg", drawing_with_a_path());
    ASSERT_EQ(refusal_of(recorded({}, carrying_scene_text(), {.frames = frames})), "");
    fs::remove(folder_ / "line.svg");
    ASSERT_EQ(refusal_of(resume(file(), "test", goes_on)), "");
    EXPECT_EQ(first_difference(frames_of(file()), whole), -1) << frames;
  }
  const auto taken = [&](const std::string& setting) {
    return refusal_of(branch(file(), 9, {take(), "brancher", {setting}, Overwrite::yes}, goes_on));
  };
  ASSERT_EQ(taken("stage[1].hand[1].height=-0.3"), "");
  EXPECT_EQ(first_difference(frames_of(take()), whole), 10);
  ASSERT_EQ(taken("stage[1].hand[1].speed=1"), "");
  EXPECT_LT(frames_in_stages(take())[1], frames_in_stages(file())[1]);
}

TEST_F(Stages, paths_that_are_not_there_are_refused_where_the_scene_names_them) {
  (void)write_file(folder_ / "line.svg", drawing_with_a_path());
  const auto refused = [&](const std::string& text) { return refusal_of(recorded({}, text)); };
  const std::string sentence = refused(carrying_scene_text("over"));
  EXPECT_THAT(sentence, HasSubstr("knot.toml:28:9: "));
  EXPECT_THAT(sentence, HasSubstr("the drawing has no path with the id 'over'"));
  EXPECT_THAT(sentence, HasSubstr("there are 'band', 'round'"));
  EXPECT_THAT(refused(carrying_scene_text("tip")),
              HasSubstr("line.svg:1: 'tip' is a <circle> that is hidden or not a path"));
  EXPECT_THAT(
      refused(small_scene_text() + "[[stage]]\nuntil = 'carried'\n[[stage.hand]]\nat = [0, 0.1]\n"
                                   "carry = 'round'\n"),
      HasSubstr("paths are those of an SVG file, but the drawing is a list of points"));
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(Stages, marks_that_are_not_there_are_refused_where_the_scene_names_them) {
  (void)write_file(folder_ / "line.svg", drawing_with_marks());
  const std::string sentence =
      refusal_of(recorded({}, drawn_in_a_file(staged_scene_text("'top'"))));
  EXPECT_THAT(sentence,
              HasSubstr("knot.toml:28:6: the drawing has no mark 'top'; it has 'middle', 'tip'"));
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(Stages, a_mark_between_two_parts_of_the_band_is_refused) {
  (void)write_file(folder_ / "line.svg",
                   "<svg xmlns='http://www.w3.org/2000/svg'><path id='band' d='M -300 0 L 300 0 "
                   "L 300 60 L -300 60'/><circle id='between' cx='0' cy='31' r='4'/></svg>");
  EXPECT_THAT(refusal_of(recorded({}, drawn_in_a_file(staged_scene_text("'between'")))),
              HasSubstr("two parts of the band pass about as near to the mark 'between'"));
}

}  // namespace ribbon::stages_test
