#include "recorder/run/run.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "files/temporary_folder.h"
#include "playback/recording_reader.h"
#include "recorder/record.h"
#include "recorder/run/start.h"
#include "recorder/small_scene.h"
#include "recorder/test_runs.h"
#include "result/refusal.h"
#include "simulation/state/state_archive.h"

namespace ribbon::run_test {

class Run : public TestInFolder {
 protected:
  void SetUp() override { scene_ = read_scene(write_small_scene(folder_)).value(); }
  Scene scene_;
};

// The state (libribbon/simulation/STATE.md) with another speed along x for all particles.
std::string set_moving(const std::string& state, int particles, double speed_m_s) {
  constexpr int before_positions = 13;
  StateArchive from(state);
  StateArchive to;
  for (int number = 0; number < static_cast<int>(state.size() / 8); ++number) {
    std::int64_t value = 0;
    from.visit(value, std::numeric_limits<std::int64_t>::min(),
               std::numeric_limits<std::int64_t>::max());
    const int of_velocities = number - before_positions - 3 * particles;
    if (of_velocities >= 0 && of_velocities < 3 * particles && of_velocities % 3 == 0)
      value = std::bit_cast<std::int64_t>(speed_m_s);
    to.visit(value, std::numeric_limits<std::int64_t>::min(),
             std::numeric_limits<std::int64_t>::max());
  }
  return to.bytes();
}

TEST_F(Run, without_loss_a_ribbon_that_leaves_its_reach_ends_the_run_with_a_sentence) {
  scene_.fastening.reset();
  scene_.air_resistance_per_s = 0;
  scene_.recording.max_position_error = 0;
  scene_.time.duration_s = 10;
  (void)record(scene_, replacing(folder_ / "still.rbn"), goes_on, {.frames = 2}).value();
  const auto header = RecordingReader::open(folder_ / "still.rbn")->header();
  auto start = find_start(scene_, std::nullopt).value();
  const double reach_m = start.fastening.reach_m();
  EXPECT_GT(reach_m, 2 * header.ribbon_length_m);
  EXPECT_LT(reach_m, 8 * header.ribbon_length_m);
  const std::string state =
      set_moving(start.fastening.state(), header.grid.particle_count(), 0.9 * reach_m);
  auto moving = FasteningProcessor::restore(
      scene_, {header.grid, header.ribbon_length_m, header.ribbon_width_m}, std::nullopt, state);
  SimulatedFrames frames(scene_, *std::move(moving), -1);
  BackgroundWriter file(RecordingWriter::create(folder_ / "fast.rbn", header).value());
  const std::string told =
      refusal_of(run(frames, plan_of(scene_).value(), false, file, goes_on, {}));
  EXPECT_THAT(told, HasSubstr("beyond the "));
  EXPECT_THAT(told, HasSubstr("max_position_error above 0"));
}

// By hand: 30 frames/s; the second comes after 33.3 ms.
TEST_F(Run, that_would_record_the_start_alone_is_refused) {
  EXPECT_EQ(plan_of(scene_, {.until_s = 0.034})->frames, 2);
  EXPECT_THAT(refusal_of(plan_of(scene_, {.until_s = 0.033})),
              HasSubstr("the run would be over before its second frame, which comes after"));
}

TEST_F(Run, a_limit_beyond_the_scene_lengthens_it_and_one_within_cuts_it_short) {
  const auto frames = [&](const RunLimit& limit) { return plan_of(scene_, limit)->frames; };
  // 0.2 s at 30 frames/s.
  EXPECT_EQ(frames({}), 7);
  EXPECT_FALSE(plan_of(scene_)->is_cut_short);
  EXPECT_EQ(frames({.until_s = 0.1}), 4);
  EXPECT_TRUE(plan_of(scene_, {.until_s = 0.1})->is_cut_short);
  EXPECT_EQ(frames({.frames = 5}), 5);
  EXPECT_EQ(plan_of(scene_, {.frames = 5})->scene.text, scene_.text);
  for (const RunLimit& limit : {RunLimit{.until_s = 0.5}, RunLimit{.frames = 16}}) {
    const RunPlan longer = plan_of(scene_, limit).value();
    EXPECT_DOUBLE_EQ(longer.scene.time.duration_s, 0.5);
    EXPECT_EQ(longer.frames, 16);
    EXPECT_FALSE(longer.is_cut_short);
  }
}

TEST_F(Run, tells_what_recording_took) {
  const RunStatistics statistics = record(scene_, replacing(folder_ / "knot.rbn"), goes_on).value();
  EXPECT_GT(statistics.recording_s, 0);
  EXPECT_GT(statistics.beside_it.writer.encoding_s, 0);
  EXPECT_GT(statistics.beside_it.writer.writing_s, 0);
  EXPECT_GT(statistics.beside_it.writer.syncing_s, 0);
  EXPECT_GT(statistics.beside_it.longest_queue, 0U);
  EXPECT_GT(statistics.share_of_recording(), 0);
  EXPECT_LT(statistics.share_of_recording(), 1);
}

}  // namespace ribbon::run_test
