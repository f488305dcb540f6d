// Where the time of the steps goes.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace ribbon {

// The phases of a step, in the order of the paper's Figure 5. The last two exclude each other: the
// gate truncates displacements, and contact = "paper" recovers from penetrations.
enum class StepPhase {
  fastening_force,
  integration,
  detection,
  repulsion,
  strain_correction,
  truncation,
  recovery
};

inline constexpr std::size_t step_phase_count = 7;

// "fastening force", "integration", ...
std::string_view word_for(StepPhase phase);

// Of many steps together.
struct PhaseSums {
  std::array<double, step_phase_count> time_s{};  // wall time, by phase
  std::int64_t detections = 0;
  std::int64_t listed_pairs = 0;  // of features, by all detections
  std::int64_t sweeps = 0;        // of the strain correction over all edges
  std::int64_t parts = 0;         // into which steps were divided
};

// At any time one phase, or none, is charged: the one of the PhaseTimer that was started last.
class StepClock {
 public:
  void count_detection(std::size_t pairs) {
    ++sums_.detections;
    sums_.listed_pairs += static_cast<std::int64_t>(pairs);
  }
  void count_sweeps(int sweeps) { sums_.sweeps += sweeps; }
  void count_parts(int parts) { sums_.parts += parts; }

  [[nodiscard]] const PhaseSums& sums() const { return sums_; }

 private:
  friend class PhaseTimer;
  using Moment = std::chrono::steady_clock::time_point;
  static constexpr int none = -1;

  // Returns the phase that was charged before.
  int charge(int phase) {
    const Moment now = std::chrono::steady_clock::now();
    if (charged_ != none)
      sums_.time_s[charged_] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return std::exchange(charged_, phase);
  }

  PhaseSums sums_;
  int charged_ = none;
  Moment last_;
};

// As long as it lives, its phase is charged; then, again, what was charged before.
class PhaseTimer {
 public:
  PhaseTimer(StepClock& clock, StepPhase phase)
      : clock_(clock), before_(clock.charge(static_cast<int>(phase))) {}
  ~PhaseTimer() { clock_.charge(before_); }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  StepClock& clock_;
  int before_;
};

}  // namespace ribbon
