#include "recorder/branch.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "playback/frames_of.h"
#include "recorder/record.h"
#include "recorder/resume.h"
#include "recorder/small_scene.h"
#include "recorder/test_runs.h"
#include "recording/size_limit.h"
#include "result/refusal.h"
#include "scene/setting.h"

namespace ribbon::branch_test {

namespace fs = std::filesystem;

class Branch : public TestInFolder {
 protected:
  void SetUp() override {
    (void)write_file(folder_ / "knot.toml", small_scene_text("2") + "checkpoint_every = 0.5\n");
    record_source(read_scene(folder_ / "knot.toml").value());
  }
  void record_source(const Scene& scene) {
    (void)record(scene, replacing(source()), goes_on).value();
    frames_ = frames_of(source());
  }
  [[nodiscard]] fs::path source() const { return folder_ / "source.rbn"; }
  [[nodiscard]] fs::path target() const { return folder_ / "take.rbn"; }

  [[nodiscard]] Result<std::optional<RunStatistics>> branched(
      int frame, const std::vector<std::string>& settings, const RunLimit& limit = {}) const {
    return branch(source(), frame, {target(), "brancher", settings, Overwrite::yes}, goes_on,
                  limit);
  }
  [[nodiscard]] std::string refusal(int frame, const std::vector<std::string>& settings,
                                    const RunLimit& limit = {}) const {
    return refusal_of(branched(frame, settings, limit));
  }
  // How many frames of the take are those of the source.
  [[nodiscard]] int common_frames() const {
    const auto take = frames_of(target());
    const int difference = first_difference(take, frames_);
    return difference < 0 ? static_cast<int>(take.size()) : difference;
  }

  std::vector<PlayedFrame> frames_;
};

TEST_F(Branch, without_a_change_it_is_the_same_take) {
  for (const int frame : {0, 1, 15, 20, 60}) {
    const auto statistics = branched(frame, {}).value();
    EXPECT_EQ(statistics->frames, 61);
    EXPECT_EQ(statistics->frames_before, frame + 1);
    EXPECT_EQ(common_frames(), 61) << frame;
  }
}

TEST_F(Branch, a_changed_setting_acts_from_its_frame_on) {
  for (const std::string setting : {"fastening.speed=1", "springs.stretch=40", "air.resistance=20",
                                    "ribbon.mass=0.5", "time.integrator=implicit", "accuracy=fine",
                                    "time.step=0.005", "gravity.acceleration=[0, -9.81, 0]"}) {
    ASSERT_EQ(refusal(20, {setting}), "");
    EXPECT_EQ(common_frames(), 21) << setting;
    const auto reader = RecordingReader::open(target()).value();
    EXPECT_EQ(reader.frame_count(), 61) << setting;
    for (int frame = 21; frame < 61; ++frame)
      EXPECT_NEAR(reader.numbers(frame)->time_s, frame / 30.0, 0.0101) << setting;
  }
}

TEST_F(Branch, a_faster_take_is_drawn_farther) {
  ASSERT_EQ(refusal(30, {"fastening.speed=1", "fastening.yield=never"}), "");
  const auto take = frames_of(target());
  const auto way_m = [](const std::vector<PlayedFrame>& frames) {
    return (frames[60].positions.col(0) - frames[30].positions.col(0)).norm();
  };
  EXPECT_GT(way_m(take), 1.3 * way_m(frames_));
}

TEST_F(Branch, of_a_scene_without_a_name_is_named_after_the_scene_s_file) {
  std::string text = small_scene_text("2");
  text.erase(0, text.find('\n') + 1);
  ASSERT_TRUE(write_file(folder_ / "knot.toml", text).has_value());
  record_source(read_scene(folder_ / "knot.toml").value());
  ASSERT_EQ(refusal(20, {"fastening.speed=1"}), "");
  const RecordingHeader header = RecordingReader::open(target())->header();
  EXPECT_EQ(header.scene_name, "knot");
  EXPECT_EQ(header.origin->scene_name, "knot");
  ASSERT_EQ(refusal(20, {"name=fast"}), "");
  EXPECT_EQ(RecordingReader::open(target())->header().scene_name, "fast");
}

TEST_F(Branch, its_header_tells_where_it_came_from_and_holds_its_own_scene) {
  ASSERT_EQ(refusal(20, {"fastening.speed=1", "name=fast"}), "");
  const auto before = RecordingReader::open(source()).value();
  const auto take = RecordingReader::open(target()).value();
  const RecordingHeader& header = take.header();
  EXPECT_EQ(header.origin,
            (Origin{before.recording_id(), "small loop", 20, "fastening.speed=1\nname=fast\n"}));
  EXPECT_EQ(header.scene_name, "fast");
  EXPECT_EQ(header.writer, "brancher");
  EXPECT_EQ(read_scene(target(), header.scene_text)->fastening->speed_m_s, 1);
  EXPECT_EQ(header.quantisation_step_m, before.header().quantisation_step_m);
  EXPECT_EQ(header.input_curve, before.header().input_curve) << "of which [curve] still tells";
  EXPECT_FALSE(before.header().origin.has_value());
}

TEST_F(Branch, can_be_resumed_and_branched_again) {
  const std::vector<std::string> settings = {"fastening.speed=1", "time.step=0.004"};
  ASSERT_TRUE(branched(20, settings).has_value());
  const auto whole = frames_of(target());
  ASSERT_TRUE(branched(20, settings, {.frames = 33}).has_value());
  ASSERT_TRUE(resume(target(), "test", goes_on).has_value());
  EXPECT_EQ(frames_of(target()), whole);
  ASSERT_TRUE(branch(target(), 40, {folder_ / "third.rbn", "test", {"springs.bend=10"}}, goes_on)
                  .has_value());
  EXPECT_EQ(first_difference(frames_of(folder_ / "third.rbn"), whole), 41);
  EXPECT_THAT(refusal_of(branch(target(), 10, {folder_ / "fourth.rbn", "test"}, goes_on)),
              HasSubstr("branch off from 'small loop'"));
}

TEST_F(Branch, goes_on_beyond_the_end_of_its_source) {
  ASSERT_TRUE(branched(60, {"time.duration=3"}).has_value());
  EXPECT_EQ(RecordingReader::open(target())->frame_count(), 91);
  EXPECT_EQ(common_frames(), 61);
  ASSERT_TRUE(branched(50, {}, {.frames = 70}).has_value());
  EXPECT_EQ(RecordingReader::open(target())->frame_count(), 70);
  EXPECT_THAT(refusal(50, {"time.duration=1"}), HasSubstr("beyond the end of the branch"));
}

TEST_F(Branch, without_loss_stays_without_loss) {
  const std::string text = read_file(folder_ / "knot.toml").value();
  const std::string setting = "recording.max_position_error=0";
  record_source(read_scene(folder_ / "knot.toml", with_setting("", text, setting).value()).value());
  EXPECT_EQ(RecordingReader::open(source())->header().quantisation_step_m, 0);
  EXPECT_GT(RecordingReader::open(source())->header().stated_gap_m, 0);
  ASSERT_EQ(refusal(20, {}), "");
  EXPECT_EQ(common_frames(), 61);
}

TEST_F(Branch, what_all_frames_have_in_common_cannot_change) {
  for (const std::string setting :
       {"ribbon.along=61", "ribbon.across=5", "ribbon.width=0.02", "curve.unit=0.002",
        "curve.clearance=0.01", "contact=paper", "fastening.axis=[1, 0, 0]",
        "fastening.axis_point=[1, 0, 0]", "recording.frames_per_second=25",
        "recording.max_position_error=1e-4", "obstacle.mesh=\"post.obj\""}) {
    const std::string sentence = refusal(20, {setting});
    EXPECT_THAT(sentence, HasSubstr("cannot change in a branch: ")) << setting << ": " << sentence;
    EXPECT_FALSE(fs::exists(target()));
  }
}

TEST_F(Branch, a_step_longer_than_a_frame_is_refused_as_such) {
  std::string text = read_file(folder_ / "knot.toml").value();
  text.erase(text.find("frames_per_second"), std::string("frames_per_second = 30\n").size());
  ASSERT_TRUE(write_file(folder_ / "knot.toml", text).has_value());
  record_source(read_scene(folder_ / "knot.toml").value());
  EXPECT_EQ(refusal(20, {"time.step=0.5"}),
            source().string() +
                ": time.step cannot change in a branch: it would be longer than the time between "
                "two frames; record a scene of its own");
  EXPECT_EQ(refusal(20, {"time.step=0.02"}, {.frames = 23}), "") << "as long as a frame";
}

TEST_F(Branch, a_width_cannot_change_where_the_scene_says_its_clearance_either) {
  const std::string text = read_file(folder_ / "knot.toml").value();
  const std::string setting = "curve.clearance=0.003";
  record_source(read_scene(folder_ / "knot.toml", with_setting("", text, setting).value()).value());
  EXPECT_THAT(refusal(20, {"ribbon.width=0.02"}), HasSubstr("ribbon.width cannot change"));
  EXPECT_EQ(refusal(20, {"ribbon.width=0.03"}), "") << "as it is";
}

TEST_F(Branch, its_header_names_the_edges_that_are_limited_in_all_of_its_frames) {
  const LimitedEdges without_diagonals{.along = true, .across = true};
  const auto header = [](const fs::path& file) { return RecordingReader::open(file)->header(); };
  ASSERT_TRUE(header(source()).limited_edges.diagonals);
  ASSERT_EQ(refusal(20, {"springs.shear=0"}), "");
  EXPECT_EQ(header(target()).limited_edges, without_diagonals);
  EXPECT_EQ(header(target()).strain_limit, 0.1);
  const fs::path third = folder_ / "third.rbn";
  ASSERT_TRUE(branch(target(), 40, {third, "test", {"springs.shear=10"}}, goes_on).has_value());
  EXPECT_EQ(header(third).limited_edges, without_diagonals) << "not in the frames before";
}

TEST_F(Branch, of_a_recording_whose_header_contradicts_its_scene_is_refused) {
  const RecordingHeader header = RecordingReader::open(source())->header();
  RecordingHeader staged = header;
  staged.stages = {"tighten", "rest"};
  RecordingHeader longer = header;
  longer.scene_text.replace(longer.scene_text.find("along = 60"), 10, "along = 61");
  for (const RecordingHeader& forged : {staged, longer}) {
    auto writer = RecordingWriter::create(source(), forged, Overwrite::yes).value();
    for (int frame = 0; frame < 3; ++frame)
      ASSERT_TRUE(writer.append(*frames_[frame].numbers, frames_[frame].positions.cast<double>()));
    ASSERT_TRUE(writer.finish());
    EXPECT_THAT(refusal(1, {}), HasSubstr("its header tells of 60 x 4 particles"));
    EXPECT_FALSE(fs::exists(target()));
  }
}

TEST_F(Branch, an_older_recording_is_replaced_only_by_a_take_that_begins) {
  ASSERT_TRUE(write_file(target(), "older"));
  EXPECT_THAT(refusal(20, {"springs.stretch=-1"}), HasSubstr("'stretch' must be"));
  EXPECT_THAT(refusal(20, {"springs.strech=1"}), HasSubstr("did you mean 'stretch'?"));
  EXPECT_THAT(refusal(20, {"springs.stretch"}), HasSubstr("is not a setting"));
  EXPECT_THAT(refusal(20, {"springs.stretch=1e9", "time.integrator=rk4"}), HasSubstr("parts"));
  EXPECT_THAT(refusal(61, {}), HasSubstr("there is no frame 62"));
  const RunObserver gives_up{[](int, int, const FrameNumbers&) { return true; },
                             [](int, int) { return false; }};
  EXPECT_FALSE(branch(source(), 20, replacing(target()), gives_up)->has_value());
  EXPECT_EQ(read_file(target()).value(), "older");
}

TEST_F(Branch, a_disk_that_fills_up_leaves_a_take_that_can_be_gone_on_with_or_none) {
  ASSERT_EQ(refusal(50, {}, {.frames = 52}), "");
  const std::uintmax_t whole_bytes = fs::file_size(target());
  int none = 0;
  for (const std::string older : {"", "older"})
    for (std::uintmax_t part = 1; part < 8; ++part) {
      fs::remove(target());
      if (!older.empty()) {
        ASSERT_TRUE(write_file(target(), older));
      }
      std::string sentence;
      {
        const SizeLimit limit(whole_bytes * part / 8);
        sentence = refusal(50, {}, {.frames = 52});
      }
      if (sentence.ends_with("and branch off again")) {
        ++none;
        EXPECT_THAT(sentence, HasSubstr(older.empty() ? "; nothing of the take is there yet; "
                                                      : "; the older file is as it was; "));
        EXPECT_EQ(fs::exists(target()) ? read_file(target()).value() : "", older);
      } else {
        EXPECT_THAT(sentence, HasSubstr(" are safe; free some space and resume the run"));
        EXPECT_EQ(refusal_of(resume(target(), "test", goes_on, {.frames = 52})), "");
      }
    }
  EXPECT_GT(none, 1);
  EXPECT_LT(none, 14);
}

TEST_F(Branch, frames_that_are_lost_are_not_passed_over) {
  std::string all = read_file(source()).value();
  const std::size_t middle = all.size() / 2;
  for (std::size_t at = middle; at < middle + 4000; ++at)
    all[at] = static_cast<char>(all[at] ^ 0x55);
  ASSERT_TRUE(write_file(source(), all));
  EXPECT_THAT(refusal(60, {}), HasSubstr("is lost"));
  EXPECT_FALSE(fs::exists(target()));
}

}  // namespace ribbon::branch_test
