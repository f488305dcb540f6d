// Where the time of the steps goes.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace ribbon {

// The stages of a step, in the order of the paper's Figure 5. The last two exclude each other: the
// gate truncates displacements, and contact = "paper" recovers from penetrations.
enum class StepStage {
  fastening_force,
  integration,
  detection,
  repulsion,
  strain_correction,
  truncation,
  recovery
};

inline constexpr std::size_t step_stage_count = 7;

// "fastening force", "integration", ...
std::string_view word_for(StepStage stage);

// Of many steps together.
struct StageSums {
  std::array<double, step_stage_count> time_s{};  // wall time, by stage
  std::int64_t detections = 0;
  std::int64_t listed_pairs = 0;  // of features, by all detections
  std::int64_t sweeps = 0;        // of the strain correction over all edges
  std::int64_t parts = 0;         // into which steps were divided
};

// At any time one stage, or none, is charged: the one of the StageTimer that was started last.
class StageClock {
 public:
  void count_detection(std::size_t pairs) {
    ++sums_.detections;
    sums_.listed_pairs += static_cast<std::int64_t>(pairs);
  }
  void count_sweeps(int sweeps) { sums_.sweeps += sweeps; }
  void count_parts(int parts) { sums_.parts += parts; }

  [[nodiscard]] const StageSums& sums() const { return sums_; }

 private:
  friend class StageTimer;
  using Moment = std::chrono::steady_clock::time_point;
  static constexpr int none = -1;

  // Returns the stage that was charged before.
  int charge(int stage) {
    const Moment now = std::chrono::steady_clock::now();
    if (charged_ != none)
      sums_.time_s[charged_] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return std::exchange(charged_, stage);
  }

  StageSums sums_;
  int charged_ = none;
  Moment last_;
};

// As long as it lives, its stage is charged; then, again, what was charged before.
class StageTimer {
 public:
  StageTimer(StageClock& clock, StepStage stage)
      : clock_(clock), before_(clock.charge(static_cast<int>(stage))) {}
  ~StageTimer() { clock_.charge(before_); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  StageClock& clock_;
  int before_;
};

}  // namespace ribbon
