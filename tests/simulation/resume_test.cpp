// A processor that was restored goes on as if it had never stopped, bit for bit.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "files/files.h"
#include "parallel/parallel.h"
#include "result/refusal.h"
#include "simulation/fastening_processor.h"
#include "simulation/loop_scene.h"
#include "simulation/state/state_archive.h"

namespace ribbon::resume_test {

using Eigen::Matrix3Xd;

constexpr double post_radius_m = 0.3;

struct Case {
  std::string name;
  Scene scene;
  std::optional<TriangleMesh> obstacle = std::nullopt;
};

// Fast enough to be in contact with the post, and with itself, after some 30 steps.
Scene fast_loop(IntegrationMethod integrator, ContactMethod contact) {
  Scene scene = scene_of_loop();
  scene.fastening->speed_m_s = contact == ContactMethod::paper ? 4 : 2;
  scene.fastening->yield_strain = 0.05;
  scene.fastening->max_speed_m_s = 2;
  scene.friction = 0.2;
  scene.contact = contact;
  scene.time.integrator = integrator;
  return scene;
}

// One that is over when its time is, and one that is not over before the end.
std::vector<StageScene> stages() {
  const auto hand = [](double begin, double end, HandTask task) {
    return HandScene{Span{begin, end}, task, {1, 0, 0}, 2, 0.05};
  };
  HandScene carries = hand(0.84, 0.9, HandTask::carry);
  carries.carry = {std::vector<Eigen::Vector2d>{{0, 900}, {400, 900}}, {{0, 0.1}, {1, 0.3}}};
  return {{.until_s = 0.155,
           .friction = 0.4,
           .hands = {hand(0, 0.4, HandTask::pull_along), hand(0.48, 0.52, HandTask::hold),
                     hand(0.6, 1, HandTask::pull_along)}},
          {.at_most_s = 9,
           .gravity_m_s2 = Eigen::Vector3d(0, 1, -3),
           .hands = {hand(0, 0.05, HandTask::pull), hand(0.5, 0.6, HandTask::pull_outwards),
                     carries, hand(0.95, 1, HandTask::hold)}}};
}

// Hands side by side, of which each carries its part: they meet in a row.
std::vector<StageScene> stage_of_neighbours() {
  const auto hand = [](double begin, double end, double y) {
    HandScene carries{Span{begin, end}, HandTask::carry, {0, 0, 0}, 2};
    carries.carry.path = std::vector<Eigen::Vector2d>{{0, y}, {400, y}};
    return carries;
  };
  return {{.at_most_s = 9,
           .hands = {hand(0.5, 0.502, 900), hand(0.502, 0.6, -900)},
           .goal = StageGoal::carried}};
}

// Neighbours move so differently that a step is divided.
constexpr const char* implicit_in_parts = "implicit, in parts";

std::vector<Case> runs() {
  std::vector<Case> all;
  for (const auto& [word, integrator] :
       {std::pair{"rk4", IntegrationMethod::rk4},
        std::pair{"symplectic_euler", IntegrationMethod::symplectic_euler},
        std::pair{"implicit", IntegrationMethod::implicit}})
    for (const auto& [contact_word, contact] :
         {std::pair{"gate", ContactMethod::gate}, std::pair{"paper", ContactMethod::paper}}) {
      const std::string name = std::string(word) + " " + contact_word;
      const Scene scene = fast_loop(integrator, contact);
      all.push_back({name + " post", scene, post(post_radius_m)});
      all.push_back({name, scene});
      all.push_back({name + " not fastened", scene, post(post_radius_m)});
      all.back().scene.fastening.reset();
    }
  all.push_back({implicit_in_parts, fast_loop(IntegrationMethod::implicit, ContactMethod::gate),
                 post(post_radius_m)});
  all.back().scene.fastening->speed_m_s = 20;
  all.push_back({"by its ends", all.front().scene, post(post_radius_m)});
  all.back().scene.fastening->pull = FasteningPull::ends;
  all.push_back({"in stages", all.front().scene});
  all.back().scene.stages = stages();
  all.push_back({"by hands side by side", all.front().scene});
  all.back().scene.stages = stage_of_neighbours();
  all.push_back({"with a width profile", all.front().scene, post(post_radius_m)});
  all.back().scene.ribbon = with_profile(all.back().scene.ribbon);
  all.push_back({"without loss", all.front().scene, post(post_radius_m)});
  all.back().scene.recording.max_position_error = 0;
  return all;
}

FasteningProcessor begun(const Case& run, int steps = 0) {
  auto fastening =
      FasteningProcessor::create(run.scene, mesh_of_loop(run.scene), run.obstacle).value();
  for (int step = 0; step < steps; ++step) fastening.step();
  return fastening;
}

RestSize size_of(const Scene& scene) {
  return mesh_of_loop(scene).size();
}

FasteningProcessor restored(const Case& run, const std::string& state,
                            Changed changed = Changed::nothing) {
  return FasteningProcessor::restore(run.scene, size_of(run.scene), run.obstacle, state, changed)
      .value();
}

// What there is to know about a processor, in full precision.
bool are_equal(FasteningProcessor& a, FasteningProcessor& b) {
  const auto tightness = [](FasteningProcessor& of) {
    const Tightness now = of.tightness().value_or(Tightness{});
    return std::vector{now.progress, now.contact_share, now.rope_length,
                       of.strain(),  of.time_s(),       of.guaranteed_gap_m()};
  };
  return a.state() == b.state() && tightness(a) == tightness(b) && a.is_tight() == b.is_tight() &&
         a.stage() == b.stage() && a.slipping_end() == b.slipping_end();
}

bool are_equal(const StepReport& a, const StepReport& b) {
  return a.recovery_iterations == b.recovery_iterations &&
         a.penetrating_edges == b.penetrating_edges && a.truncated == b.truncated &&
         a.pull == b.pull;
}

TEST(Resume, goes_on_to_the_same_bits_from_any_step) {
  constexpr int last = 50;
  for (const Case& run : runs()) {
    FasteningProcessor uninterrupted = begun(run);
    // Each of these was restored at another step, and steps along.
    std::vector<FasteningProcessor> followers;
    double contact_share = 0;
    int most_parts = 0;  // of a step before a cut
    for (int step = 0; step < last; ++step) {
      if (step % 10 == 0 || step == 1 || step == last - 1) {
        followers.push_back(restored(run, uninterrupted.state()));
        most_parts = std::max(most_parts, uninterrupted.substeps());
      }
      const StepReport report = uninterrupted.step();
      if (step % 20 == 0)
        contact_share = uninterrupted.tightness().value_or(Tightness{}).contact_share;
      for (FasteningProcessor& follower : followers)
        ASSERT_TRUE(are_equal(follower.step(), report)) << run.name << ", step " << step;
    }
    for (FasteningProcessor& follower : followers)
      EXPECT_TRUE(are_equal(follower, uninterrupted)) << run.name;
    EXPECT_TRUE(most_parts > 1 || run.name != implicit_in_parts);
    EXPECT_TRUE(contact_share > 0.05 || !run.scene.fastening || !run.obstacle) << run.name;
  }
}

TEST(Resume, a_state_begins_with_the_version_that_its_document_states) {
  StateArchive archive(begun(runs().front()).state());
  std::int64_t version = 0;
  archive.visit(version, 1, std::numeric_limits<std::int64_t>::max());
  EXPECT_THAT(read_file(RIBBON_STATE_DOCUMENT).value(),
              HasSubstr("\n| version | i64 | " + std::to_string(version) + " |\n"));
}

// Two seconds of memory come round; the ribbon is tight, and both notice in the same step.
TEST(Resume, remembers_how_the_ribbon_was_drawn_tight) {
  Case run{"post", scene_of_loop(), post(post_radius_m)};
  run.scene.fastening->yield_strain = 0.05;
  run.scene.fastening->speed_m_s = 1;
  FasteningProcessor uninterrupted = begun(run, 230);
  FasteningProcessor follower = restored(run, uninterrupted.state());
  int steps = 0;
  for (; steps < 1000 && !uninterrupted.is_tight(); ++steps) {
    uninterrupted.step();
    follower.step();
    ASSERT_EQ(uninterrupted.is_tight(), follower.is_tight()) << steps;
  }
  EXPECT_LT(steps, 1000);
  EXPECT_TRUE(are_equal(uninterrupted, follower));
}

TEST(Resume, does_not_depend_on_the_number_of_threads) {
  const Case run{"post", fast_loop(IntegrationMethod::implicit, ContactMethod::gate),
                 post(post_radius_m)};
  std::vector<std::string> ends;
  for (const int threads : {1, 2, 5}) {
    set_thread_limit(threads);
    FasteningProcessor first = begun(run, 25);
    set_thread_limit(6 - threads);
    FasteningProcessor second = restored(run, first.state());
    for (int step = 0; step < 25; ++step) second.step();
    ends.push_back(second.state());
  }
  set_thread_limit(0);
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_EQ(ends[0], ends[2]);
}

// What looks at a processor, as measuring a frame or saving its state does, changes nothing.
TEST(Resume, looking_leaves_no_trace) {
  for (const Case& run : runs()) {
    FasteningProcessor watched = begun(run);
    FasteningProcessor alone = begun(run);
    for (int step = 0; step < 40; ++step) {
      (void)watched.tightness();
      (void)watched.state();
      watched.step();
      alone.step();
    }
    EXPECT_EQ(watched.state(), alone.state()) << run.name;
  }
}

TEST(Resume, a_start_that_was_grown_is_not_searched_again) {
  Case run{"wide", scene_of_loop(), post(post_radius_m)};
  run.scene.ribbon.width_m = 0.3;
  FasteningProcessor grown = begun(run);
  ASSERT_EQ(grown.start().kind, StartKind::grown);
  FasteningProcessor again = restored(run, grown.state());
  EXPECT_EQ(again.start().kind, StartKind::grown);
  EXPECT_EQ(again.phase_sums().detections, 0);
  EXPECT_GT(again.guaranteed_gap_m(), 0);
  grown.step();
  again.step();
  EXPECT_TRUE(are_equal(grown, again));
}

std::string refusal(const Case& run, const std::string& state) {
  return refusal_of(
      FasteningProcessor::restore(run.scene, size_of(run.scene), run.obstacle, state));
}

constexpr auto lowest = std::numeric_limits<std::int64_t>::min();
constexpr auto highest = std::numeric_limits<std::int64_t>::max();

// A state as it is visited, and back.
std::vector<std::int64_t> numbers_of(const std::string& state) {
  StateArchive archive(state);
  std::vector<std::int64_t> numbers(state.size() / 8);
  for (std::int64_t& number : numbers) archive.visit(number, lowest, highest);
  EXPECT_TRUE(archive.finish().has_value());
  return numbers;
}
std::string state_of(std::vector<std::int64_t> numbers) {
  StateArchive archive;
  for (std::int64_t& number : numbers) archive.visit(number, lowest, highest);
  return archive.bytes();
}

TEST(Resume, every_cut_state_and_every_other_length_is_refused) {
  for (const ContactMethod contact : {ContactMethod::gate, ContactMethod::paper}) {
    Case run{"small", fast_loop(IntegrationMethod::rk4, contact)};
    run.scene.ribbon.along = 40;
    FasteningProcessor fastening = begun(run, 1);
    const std::string state = fastening.state();
    ASSERT_EQ(refusal(run, state), "");
    for (std::size_t size = 0; size < state.size(); size += 61)
      EXPECT_THAT(refusal(run, state.substr(0, size)), HasSubstr("does not fit the scene")) << size;
    std::vector<std::int64_t> numbers = numbers_of(state);
    ASSERT_EQ(state_of(numbers), state);
    numbers.push_back(0);
    EXPECT_THAT(refusal(run, state_of(numbers)), HasSubstr("longer than"));
    numbers.resize(numbers.size() - 2);
    EXPECT_THAT(refusal(run, state_of(numbers)), HasSubstr("cut off"));
    EXPECT_THAT(refusal(run, state + 'x'), HasSubstr("cut off"));
  }
}

// Whatever is read back is either refused or can be gone on from.
TEST(Resume, every_number_of_a_state_may_be_wrong) {
  Case run{"small", fast_loop(IntegrationMethod::symplectic_euler, ContactMethod::gate)};
  run.scene.ribbon.along = 20;
  run.scene.ribbon.across = 2;
  FasteningProcessor fastening = begun(run, 1);
  const std::vector<std::int64_t> state = numbers_of(fastening.state());
  int refused = 0;
  for (std::size_t at = 0; at < state.size(); ++at)
    for (const std::int64_t other : {std::int64_t{0}, std::int64_t{-1}, highest}) {
      std::vector<std::int64_t> wrong = state;
      wrong[at] = other;
      auto accepted =
          FasteningProcessor::restore(run.scene, size_of(run.scene), run.obstacle, state_of(wrong));
      refused += accepted ? 0 : 1;
      if (!accepted) continue;
      accepted->step();
      EXPECT_TRUE(accepted->positions().allFinite()) << at;
    }
  // -1 and the highest number are not finite as numbers and are impossible as counts.
  EXPECT_GE(refused, static_cast<int>(2 * state.size()) - 4);
}

// Each in place of every number: a count of -4.6e18 or, where it is a measure, -0.5 of it.
TEST(Resume, what_cannot_have_been_is_refused_and_told_why) {
  Case run{"in stages", fast_loop(IntegrationMethod::symplectic_euler, ContactMethod::gate)};
  run.scene.ribbon.along = 20;
  run.scene.ribbon.across = 2;
  run.scene.stages = stages();
  FasteningProcessor fastening = begun(run, 20);
  const std::vector<std::int64_t> state = numbers_of(fastening.state());
  std::string refusals;
  for (std::size_t at = 0; at < state.size(); ++at) {
    std::vector<std::int64_t> wrong = state;
    wrong[at] = std::bit_cast<std::int64_t>(-0.5);
    refusals += refusal(run, state_of(wrong));
  }
  for (const char* words :
       {"another version", "reaches nowhere", "an impossible time", "a stage began after it",
        "an impossible force", "from before its begin", "a count in it is impossible"})
    EXPECT_THAT(refusals, HasSubstr(words));
}

TEST(Resume, a_state_of_another_scene_is_refused_and_told_why) {
  const Case run{"post", scene_of_loop(), post(post_radius_m)};
  FasteningProcessor fastening = begun(run);
  const std::string state = fastening.state();
  const auto expect_refused = [&](const auto& change, const std::string& words) {
    Case other = run;
    change(other.scene);
    EXPECT_THAT(refusal(other, state), HasSubstr(words));
  };
  expect_refused([](Scene& scene) { scene.ribbon.along = 121; }, "particles along");
  expect_refused([](Scene& scene) { scene.ribbon.across = 5; }, "particles across");
  expect_refused([](Scene& scene) { scene.fastening.reset(); }, "its ribbon is fastened");
  expect_refused([](Scene& scene) { scene.time.step_s = 0.005; }, "time.step");
  std::vector<std::int64_t> newer = numbers_of(state);
  ++newer[0];
  EXPECT_THAT(refusal(run, state_of(newer)), HasSubstr("another version"));
  EXPECT_EQ(refusal(run, state), "");
}

TEST(Resume, changed_settings_act_from_there_on) {
  const Case run{"post", scene_of_loop(), post(post_radius_m)};
  FasteningProcessor before = begun(run, 20);
  const std::string state = before.state();
  const auto goes_on = [&](const Scene& scene) {
    auto changed = restored({"", scene, run.obstacle}, state, Changed::settings);
    EXPECT_EQ(changed.positions(), before.positions());
    EXPECT_EQ(changed.time_s(), before.time_s());
    for (int step = 0; step < 20; ++step) changed.step();
    return changed.positions();
  };
  const Matrix3Xd as_it_was = goes_on(run.scene);
  Scene scene = run.scene;
  scene.fastening->speed_m_s *= 3;
  const Matrix3Xd faster = goes_on(scene);
  const auto way_m = [&](const Matrix3Xd& to) { return (to - before.positions()).norm(); };
  EXPECT_GT(way_m(faster), 1.5 * way_m(as_it_was));
  scene = run.scene;
  scene.springs.stretch *= 4;
  scene.ribbon.mass_kg *= 2;
  scene.time.integrator = IntegrationMethod::implicit;
  EXPECT_NE(goes_on(scene), as_it_was);
}

// Measured anew, but for a ribbon that moves already: it does not seem to gain on the command.
TEST(Resume, with_changed_settings_progress_counts_from_there) {
  Case run{"loop", scene_of_loop()};
  FasteningProcessor before = begun(run, 60);
  run.scene.springs.bend *= 1.01;
  auto changed = restored(run, before.state(), Changed::settings);
  EXPECT_EQ(changed.tightness()->progress, 1) << "nothing was commanded yet";
  for (int step = 0; step < 10; ++step) {
    before.step();
    changed.step();
  }
  EXPECT_NE(changed.tightness()->progress, before.tightness()->progress);
  EXPECT_NEAR(changed.tightness()->progress, before.tightness()->progress, 0.15);
}

TEST(Resume, the_clock_goes_on_with_another_step) {
  Case run{"post", scene_of_loop(), post(post_radius_m)};
  FasteningProcessor before = begun(run, 20);
  run.scene.time.step_s = 0.004;
  auto changed = restored(run, before.state(), Changed::settings);
  EXPECT_DOUBLE_EQ(changed.time_s(), 0.2);
  EXPECT_EQ(changed.steps(), 20);
  EXPECT_EQ(changed.steps_at(0.2), 20);
  EXPECT_EQ(changed.steps_at(0.22), 25);
  EXPECT_EQ(changed.steps_at(0.2201), 26);
  for (int step = 0; step < 5; ++step) changed.step();
  EXPECT_DOUBLE_EQ(changed.time_s(), 0.22);
  auto again = restored(run, changed.state());
  EXPECT_EQ(again.time_s(), changed.time_s());
  again.step();
  changed.step();
  EXPECT_TRUE(are_equal(again, changed));
}

TEST(Resume, springs_too_stiff_for_the_step_are_refused_as_at_the_start) {
  const Case run{"post", scene_of_loop(), post(post_radius_m)};
  Case stiff = run;
  stiff.scene.springs.stretch = 1e12;
  stiff.scene.time.integrator = IntegrationMethod::symplectic_euler;
  EXPECT_THAT(refusal(stiff, begun(run).state()), HasSubstr("parts"));
}

TEST(Resume, a_fabric_too_thick_for_the_particles_is_refused_as_at_the_start) {
  const Case run{"post", scene_of_loop(), post(post_radius_m)};
  Case thick = run;
  thick.scene.cloth = ClothScene{.fabric = {.name = "felt"}, .tells_thickness = true};
  thick.scene.ribbon.thickness_m = 1;
  const std::string remedy = "set a smaller thickness of your own in [ribbon]";
  EXPECT_THAT(refusal(thick, begun(run).state()), HasSubstr(remedy));
  EXPECT_THAT(refusal_of(FasteningProcessor::create(thick.scene, mesh_of_loop(thick.scene),
                                                    thick.obstacle)),
              HasSubstr(remedy));
}

}  // namespace ribbon::resume_test
