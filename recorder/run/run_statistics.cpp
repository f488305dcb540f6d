#include "recorder/run/run_statistics.h"

#include <algorithm>
#include <string_view>

#include "inspection/figures_json.h"
#include "inspection/tightness_progress_text.h"
#include "text/json.h"
#include "text/number_text.h"

namespace ribbon {

void RunStatistics::add(const FrameNumbers& frame) {
  ++frames;
  simulated_s = frame.time_s;
  last_strain = frame.worst_strain;
  worst_strain = std::max(worst_strain, frame.worst_strain);
  last_penetrating_edges = frame.penetrating_edges;
  worst_penetrating_edges = std::max(worst_penetrating_edges, frame.penetrating_edges);
  tightness = frame.tightness;
  recovery_iterations += frame.recovery_iterations;
}

double RunStatistics::steps_per_second() const {
  return simulation_s > 0 ? static_cast<double>(computed_steps) / simulation_s : 0;
}

double RunStatistics::per_step(std::int64_t count) const {
  return static_cast<double>(count) /
         static_cast<double>(std::max(std::int64_t{1}, computed_steps));
}

double RunStatistics::substeps() const {
  return per_step(phases.parts);
}

double RunStatistics::share_of_recording() const {
  const double all_s = simulation_s + measuring_s + recording_s;
  return all_s > 0 ? recording_s / all_s : 0;
}

double RunStatistics::bits_per_vertex_and_frame() const {
  const double vertices = static_cast<double>(along) * across;
  return frames > 0 ? 8.0 * static_cast<double>(bytes) / vertices / frames : 0;
}

RunStatistics statistics_of(const RecordingReader& reader, int frames) {
  const RecordingHeader& header = reader.header();
  RunStatistics statistics{.scene_name = header.scene_name,
                           .along = header.grid.along,
                           .across = header.grid.across,
                           .frames_before = frames};
  for (int frame = 0; frame < frames; ++frame) {
    if (const auto numbers = reader.numbers(frame))
      statistics.add(*numbers);
    else
      ++statistics.frames;
  }
  return statistics;
}

namespace {

std::string tightness_text(const TightnessNumbers& tightness) {
  return tightness_progress_text(tightness.progress) +
         filled_in(", rope length {:.1f} widths", tightness.rope_length);
}

std::string time_text(double time_s) {
  return (time_s < 1 ? short_number(time_s, 3) : decimals(time_s, 1)) + " s";
}

std::string slip_text(std::string_view end, double time_s) {
  return filled_in(
      "; ended at {}: the {} end would slip out of its knot; draw a longer tail, or hold it",
      time_text(time_s), end);
}

// Nothing where the run lasted as long as it was to.
std::string ending_text(const RunStatistics& statistics) {
  if (statistics.ending == RunEnding::limit)
    return "; ended at " + time_text(statistics.simulated_s) + ", as asked";
  if (statistics.ending == RunEnding::stopped) return "; ended early by the user";
  if (statistics.ending == RunEnding::first_end_slips)
    return slip_text("first", statistics.simulated_s);
  if (statistics.ending == RunEnding::second_end_slips)
    return slip_text("second", statistics.simulated_s);
  if (statistics.ending == RunEnding::stages_over)
    return "; ended at " + time_text(statistics.simulated_s) + ", when its stages were over";
  if (!statistics.until_tight || !statistics.tightness) return "";
  return (statistics.ending == RunEnding::tight ? "; ended tight: " : "; not yet tight: ") +
         tightness_text(*statistics.tightness);
}

// Cloth that is held to less than this is another one; without an error of its own no scene is, but
// for the finest meshes.
std::string held_text(const RunStatistics& statistics) {
  constexpr double usual = 0.05;
  if (statistics.held_strain >= usual) return "";
  return filled_in(" (edges are held to {:.1f} %, as recorded coordinates are coarse)",
                   100 * statistics.held_strain);
}

std::string given_up_text(const RunStatistics& statistics) {
  std::string text;
  for (const std::string& stage : statistics.stages_given_up)
    text += filled_in("; 'at_most' ended '{}' before its goal was reached", stage);
  return text;
}

std::string profile_line(std::string_view what, double time_s, double of_s, std::int64_t times) {
  const double each_ms = times > 0 ? 1000 * time_s / static_cast<double>(times) : 0;
  const double percent = of_s > 0 ? 100 * time_s / of_s : 0;
  return filled_in("  {:<17}{:>6.1f} %{:>11.3f} ms\n", what, percent, each_ms);
}

Json phases_json(const PhaseSums& phases) {
  Json json;
  for (std::size_t phase = 0; phase < step_phase_count; ++phase) {
    std::string name(word_for(static_cast<StepPhase>(phase)));
    std::replace(name.begin(), name.end(), ' ', '_');
    json.set(name + "_s", phases.time_s[phase]);
  }
  json.set("detections", phases.detections);
  json.set("listed_pairs", phases.listed_pairs);
  json.set("sweeps", phases.sweeps);
  return json;
}

}  // namespace

std::string profile_text(const RunStatistics& statistics) {
  const double all_s = statistics.simulation_s + statistics.measuring_s + statistics.recording_s;
  const int frames = statistics.frames - statistics.frames_before;
  std::string text =
      filled_in("a step, {} times, by {} in {:.1f} parts:\n", statistics.computed_steps,
                statistics.integrator, statistics.substeps());
  // A step truncates or recovers; the other takes no time.
  for (std::size_t phase = 0; phase < step_phase_count; ++phase)
    if (const double time_s = statistics.phases.time_s[phase]; time_s > 0)
      text += profile_line(word_for(static_cast<StepPhase>(phase)), time_s, all_s,
                           statistics.computed_steps);
  text += filled_in("a frame, {} times:\n", frames) +
          profile_line("measuring", statistics.measuring_s, all_s, frames) +
          profile_line("recording", statistics.recording_s, all_s, frames) +
          "beside these, of the same time:\n" +
          profile_line("encoding", statistics.beside_it.writer.encoding_s, all_s, frames) +
          profile_line("writing", statistics.beside_it.writer.writing_s, all_s, frames) +
          profile_line("syncing", statistics.beside_it.writer.syncing_s, all_s, frames);
  const PhaseSums& sums = statistics.phases;
  return text + filled_in(
                    "in a step {:.2f} detections, {:.0f} pairs of features listed, {:.1f} "
                    "sweeps over all edges\n",
                    statistics.per_step(sums.detections), statistics.per_step(sums.listed_pairs),
                    statistics.per_step(sums.sweeps));
}

std::string summary_line(const RunStatistics& statistics) {
  return filled_in("{} start; {} frames, {} in {} steps ({:.1f} steps/s); ", statistics.start,
                   statistics.frames, time_text(statistics.simulated_s), statistics.steps,
                   statistics.steps_per_second()) +
         filled_in("worst strain of a spring {:.1f} %", 100 * statistics.worst_strain) +
         held_text(statistics) +
         filled_in("; penetrating edges {} at worst, {} at last; ",
                   statistics.worst_penetrating_edges, statistics.last_penetrating_edges) +
         filled_in("{:.1f} MB ({:.1f} bits per vertex and frame)",
                   static_cast<double>(statistics.bytes) / 1e6,
                   statistics.bits_per_vertex_and_frame()) +
         given_up_text(statistics) + ending_text(statistics) +
         (statistics.outcome ? "; " + outcome_text(*statistics.outcome) : "");
}

std::string statistics_json(const RunStatistics& statistics) {
  const Json json{
      {"scene", statistics.scene_name},
      {"along", statistics.along},
      {"across", statistics.across},
      {"start", statistics.start},
      {"start_s", statistics.start_s},
      {"integrator", statistics.integrator},
      {"substeps", statistics.substeps()},
      {"steps", statistics.steps},
      {"computed_steps", statistics.computed_steps},
      {"frames", statistics.frames},
      {"frames_before", statistics.frames_before},
      {"simulated_s", statistics.simulated_s},
      {"simulation_s", statistics.simulation_s},
      {"phases", phases_json(statistics.phases)},
      {"measuring_s", statistics.measuring_s},
      {"recording_s", statistics.recording_s},
      {"recording_share", statistics.share_of_recording()},
      {"encoding_s", statistics.beside_it.writer.encoding_s},
      {"writing_s", statistics.beside_it.writer.writing_s},
      {"syncing_s", statistics.beside_it.writer.syncing_s},
      {"longest_queue", statistics.beside_it.longest_queue},
      {"steps_per_second", statistics.steps_per_second()},
      {"bytes", statistics.bytes},
      {"bits_per_vertex_and_frame", statistics.bits_per_vertex_and_frame()},
      {"worst_strain", statistics.worst_strain},
      {"last_strain", statistics.last_strain},
      {"held_strain", statistics.held_strain},
      {"worst_penetrating_edges", statistics.worst_penetrating_edges},
      {"last_penetrating_edges", statistics.last_penetrating_edges},
      {"recovery_iterations", statistics.recovery_iterations},
      {"ending", word_for(statistics.ending)},
      {"stages_given_up", statistics.stages_given_up},
      {"tightness", tightness_json(statistics.tightness)},
      {"outcome", outcome_json(statistics.outcome)},
  };
  return json.text();
}

}  // namespace ribbon
