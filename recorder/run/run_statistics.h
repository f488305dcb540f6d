// The figures of one run.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "inspection/outcome.h"
#include "playback/recording_reader.h"
#include "recording/records/recording.h"
#include "recording/writer/background_writer.h"
#include "simulation/step/step_clock.h"

namespace ribbon {

struct RunStatistics {
  std::string scene_name = {};
  int along = 0;
  int across = 0;
  std::string start = {};       // how it was made: "free", "grown" or "recovered"
  double start_s = 0;           // wall time that took
  std::string integrator = {};  // as scenes name it
  std::int64_t steps = 0;       // that led to the last frame
  // By this run: others may have been before it.
  std::int64_t computed_steps = 0;
  int frames = 0;
  int frames_before = 0;  // how many there were before this run
  double simulated_s = 0;
  double simulation_s = 0;  // wall time spent in steps
  PhaseSums phases = {};    // what it was spent for
  double measuring_s = 0;   // wall time spent on the numbers of frames
  double recording_s = 0;   // wall time for which recording them, and checkpoints, blocked the run
  BackgroundFigures beside_it = {};  // of the writer that worked beside the run
  std::uint64_t bytes = 0;           // of the recording
  RunEnding ending = RunEnding::unknown;
  bool until_tight = false;  // was the run to end when the ribbon is tight?
  // Names of those that 'at_most' has ended before their goal was reached.
  std::vector<std::string> stages_given_up = {};

  double worst_strain = 0;  // over all frames
  double last_strain = 0;
  // To what edges were held; infinite where none were.
  double held_strain = std::numeric_limits<double>::infinity();
  std::uint32_t worst_penetrating_edges = 0;  // over all frames
  std::uint32_t last_penetrating_edges = 0;
  std::uint64_t recovery_iterations = 0;  // at the start and in all steps

  // Of the last frame; none without a fastening.
  std::optional<TightnessNumbers> tightness = std::nullopt;
  std::optional<Outcome> outcome = std::nullopt;

  void add(const FrameNumbers& frame);
  [[nodiscard]] double steps_per_second() const;
  // Of a count over all steps that this run computed.
  [[nodiscard]] double per_step(std::int64_t count) const;
  // Into how many parts a step was divided, in the mean.
  [[nodiscard]] double substeps() const;
  // Of the wall time of this run.
  [[nodiscard]] double share_of_recording() const;
  [[nodiscard]] double bits_per_vertex_and_frame() const;
};

// What there is to tell of the first frames of a recording, so many.
RunStatistics statistics_of(const RecordingReader& reader, int frames);

// Where the time of the run went, in lines of text: each phase of the steps, and the frames.
std::string profile_text(const RunStatistics& statistics);

// For people: one line. For programs: JSON.
std::string summary_line(const RunStatistics& statistics);
std::string statistics_json(const RunStatistics& statistics);

}  // namespace ribbon
