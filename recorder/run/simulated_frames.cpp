#include "recorder/run/simulated_frames.h"

#include <optional>
#include <utility>

#include "recorder/run/stopwatch.h"

namespace ribbon {

namespace {

// What the steps since the last frame brought about.
class StepSums {
 public:
  void add(const StepReport& report) {
    ++steps_;
    recovery_iterations_ += report.recovery_iterations;
    penetrating_edges_ = report.penetrating_edges;
    truncated_ += report.truncated;
    pull_ += report.pull;
  }

  [[nodiscard]] std::uint32_t recovery_iterations() const {
    return static_cast<std::uint32_t>(recovery_iterations_);
  }
  // After the last step.
  [[nodiscard]] std::uint32_t penetrating_edges() const {
    return static_cast<std::uint32_t>(penetrating_edges_);
  }
  // Per step; before the first one nothing is truncated and nobody has yielded.
  [[nodiscard]] double mean_truncated() const { return steps_ > 0 ? truncated_ / steps_ : 0; }
  [[nodiscard]] double mean_pull() const { return steps_ > 0 ? pull_ / steps_ : 1; }

 private:
  int steps_ = 0;
  std::int64_t recovery_iterations_ = 0;
  int penetrating_edges_ = 0;
  double truncated_ = 0;
  double pull_ = 0;
};

std::optional<TightnessNumbers> tightness_numbers(FasteningProcessor& fastening,
                                                  const StepSums& sums, Eigen::Index particles) {
  const auto tightness = fastening.tightness();
  if (!tightness) return std::nullopt;
  return TightnessNumbers{
      .progress = static_cast<float>(tightness->progress),
      .truncated = static_cast<float>(sums.mean_truncated() / static_cast<double>(particles)),
      .pull = static_cast<float>(sums.mean_pull()),
      .contact = static_cast<float>(tightness->contact_share),
      .rope_length = static_cast<float>(tightness->rope_length)};
}

// stage: of the last step, from 0; nothing: of none.
FrameNumbers frame_numbers(FasteningProcessor& fastening, const StepSums& sums,
                           std::optional<int> stage, Eigen::Index particles) {
  return {.time_s = fastening.time_s(),
          .worst_strain = fastening.strain(),
          .penetrating_edges = sums.penetrating_edges(),
          .recovery_iterations = sums.recovery_iterations(),
          .tightness = tightness_numbers(fastening, sums, particles),
          .stage = static_cast<std::uint8_t>(stage.value_or(-1) + 1)};
}

}  // namespace

SimulatedFrames::SimulatedFrames(const Scene& scene, FasteningProcessor fastening, int index)
    : fastening_(std::move(fastening)),
      frames_per_second_(scene.recording.frames_per_second),
      index_(index) {}

SimulatedFrame SimulatedFrames::next() {
  Stopwatch stopwatch;
  StepSums sums;
  if (++index_ == 0)
    sums.add({.recovery_iterations = fastening_.start().recovery_iterations,
              .penetrating_edges = fastening_.start().penetrating_edges});
  const std::int64_t last = fastening_.steps_at(index_ / frames_per_second_);
  auto stage = fastening_.stage();
  for (; fastening_.steps() < last; ++effort_.steps) {
    const bool hands_have_let_go = fastening_.stages_are_over();
    sums.add(fastening_.step());
    stage = hands_have_let_go ? std::nullopt : fastening_.stage();
  }
  effort_.simulation_s += stopwatch.lap();
  SimulatedFrame frame{.index = index_, .numbers = {}, .positions = fastening_.positions()};
  frame.numbers = frame_numbers(fastening_, sums, stage, frame.positions.cols());
  effort_.measuring_s += stopwatch.lap();
  return frame;
}

}  // namespace ribbon
