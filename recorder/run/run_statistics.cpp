#include "recorder/run/run_statistics.h"

#include <algorithm>

#include "inspection/figures_json.h"
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
                           .first_frame = frames};
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
  return "progress " + decimals(100 * tightness.progress, 1) + " %, rope length " +
         decimals(tightness.rope_length, 1) + " widths";
}

// Nothing where the run lasted as long as it was to.
std::string ending_text(const RunStatistics& statistics) {
  if (statistics.limit_reached)
    return "; ended at " + decimals(statistics.simulated_s, 1) + " s, as asked";
  if (statistics.ending == RunEnding::stopped) return "; ended early by the user";
  if (!statistics.until_tight || !statistics.tightness) return "";
  return (statistics.ending == RunEnding::tight ? "; ended tight: " : "; not yet tight: ") +
         tightness_text(*statistics.tightness);
}

// Text in a column of so many characters.
std::string left(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}
std::string right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string profile_line(const std::string& what, double time_s, double of_s, long times) {
  const double each_ms = times > 0 ? 1000 * time_s / static_cast<double>(times) : 0;
  const double percent = of_s > 0 ? 100 * time_s / of_s : 0;
  return "  " + left(what, 17) + right(decimals(percent, 1), 6) + " %" +
         right(decimals(each_ms, 3), 11) + " ms\n";
}

std::string per_step(long count, const RunStatistics& statistics, int digits) {
  return decimals(
      static_cast<double>(count) / static_cast<double>(std::max(1L, statistics.computed_steps)),
      digits);
}

Json stages_json(const StageSums& stages) {
  Json json;
  for (std::size_t stage = 0; stage < step_stage_count; ++stage) {
    std::string name(word_for(static_cast<StepStage>(stage)));
    std::replace(name.begin(), name.end(), ' ', '_');
    json.set(name + "_s", stages.time_s[stage]);
  }
  json.set("detections", stages.detections);
  json.set("listed_pairs", stages.listed_pairs);
  json.set("sweeps", stages.sweeps);
  return json;
}

}  // namespace

std::string profile_text(const RunStatistics& statistics) {
  const double all_s = statistics.simulation_s + statistics.measuring_s + statistics.recording_s;
  const int frames = statistics.frames - statistics.first_frame;
  std::string text = "a step, " + std::to_string(statistics.computed_steps) + " times:\n";
  // A step truncates or recovers; the other takes no time.
  for (std::size_t stage = 0; stage < step_stage_count; ++stage)
    if (const double time_s = statistics.stages.time_s[stage]; time_s > 0)
      text += profile_line(std::string(word_for(static_cast<StepStage>(stage))), time_s, all_s,
                           statistics.computed_steps);
  text += "a frame, " + std::to_string(frames) + " times:\n" +
          profile_line("measuring", statistics.measuring_s, all_s, frames) +
          profile_line("recording", statistics.recording_s, all_s, frames) +
          "beside these, of the same time:\n" +
          profile_line("encoding", statistics.beside_it.writer.encoding_s, all_s, frames) +
          profile_line("writing", statistics.beside_it.writer.writing_s, all_s, frames) +
          profile_line("syncing", statistics.beside_it.writer.syncing_s, all_s, frames);
  return text + "in a step " + per_step(statistics.stages.detections, statistics, 2) +
         " detections, " + per_step(statistics.stages.listed_pairs, statistics, 0) +
         " pairs of features listed, " + per_step(statistics.stages.sweeps, statistics, 1) +
         " sweeps over all edges\n";
}

std::string summary_line(const RunStatistics& statistics) {
  return statistics.start + " start; " + std::to_string(statistics.frames) + " frames, " +
         decimals(statistics.simulated_s, 1) + " s in " + std::to_string(statistics.steps) +
         " steps (" + decimals(statistics.steps_per_second(), 1) +
         " steps/s); worst strain of a spring " + decimals(100 * statistics.worst_strain, 1) +
         " %; penetrating edges " + std::to_string(statistics.worst_penetrating_edges) +
         " at worst, " + std::to_string(statistics.last_penetrating_edges) + " at last; " +
         decimals(static_cast<double>(statistics.bytes) / 1e6, 1) + " MB (" +
         decimals(statistics.bits_per_vertex_and_frame(), 1) + " bits per vertex and frame)" +
         ending_text(statistics) +
         (statistics.outcome ? "; " + outcome_text(*statistics.outcome) : "");
}

std::string statistics_json(const RunStatistics& statistics) {
  const Json json{
      {"scene", statistics.scene_name},
      {"along", statistics.along},
      {"across", statistics.across},
      {"start", statistics.start},
      {"start_s", statistics.start_s},
      {"steps", statistics.steps},
      {"computed_steps", statistics.computed_steps},
      {"frames", statistics.frames},
      {"first_frame", statistics.first_frame},
      {"simulated_s", statistics.simulated_s},
      {"simulation_s", statistics.simulation_s},
      {"stages", stages_json(statistics.stages)},
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
      {"worst_penetrating_edges", statistics.worst_penetrating_edges},
      {"last_penetrating_edges", statistics.last_penetrating_edges},
      {"recovery_iterations", statistics.recovery_iterations},
      {"ending", word_for(statistics.ending)},
      {"tightness", tightness_json(statistics.tightness)},
      {"outcome", outcome_json(statistics.outcome)},
  };
  return json.text();
}

}  // namespace ribbon
