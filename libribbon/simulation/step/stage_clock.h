// Where the time of the steps goes.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>

namespace ribbon {

// The stages of a step, as in the paper's Figure 5. `errors`: what the gate does, or recovery.
enum class Stage { fastening, displacement, detection, repulsion, smoothing, errors };

inline constexpr std::size_t stage_count = 6;

// As above.
std::string_view word_for(Stage stage);

// Of many steps together.
struct StageSums {
  std::array<double, stage_count> time_s{};  // wall time, by stage
  long detections = 0;
  long listed_pairs = 0;  // of features, by all detections
  long sweeps = 0;        // of the smoothing over all edges
};

// At any time one stage, or none, is charged.
class StageClock {
 public:
  void charge(Stage stage) { charge_to(&sums_.time_s[static_cast<std::size_t>(stage)]); }
  void stop() { charge_to(nullptr); }

  void count_detection(std::size_t pairs) {
    ++sums_.detections;
    sums_.listed_pairs += static_cast<long>(pairs);
  }
  void count_sweeps(int sweeps) { sums_.sweeps += sweeps; }

  // Since the last reset, which also charges no stage.
  [[nodiscard]] const StageSums& sums() const { return sums_; }
  void reset() {
    sums_ = {};
    charged_s_ = nullptr;
  }

 private:
  void charge_to(double* charged_s) {
    const auto now = std::chrono::steady_clock::now();
    if (charged_s_ != nullptr) *charged_s_ += std::chrono::duration<double>(now - last_).count();
    charged_s_ = charged_s;
    last_ = now;
  }

  StageSums sums_;
  double* charged_s_ = nullptr;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace ribbon
