// The weights of a prediction (FORMAT.md, section 8.5).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace ribbon {

// What a frame is predicted from.
enum class Prediction : std::uint8_t {
  intra = 0,  // itself alone
  p = 1,      // up to three frames before it, the nearest first
  b = 2       // the frame before and the one after it, then the next ones outwards
};

// Particles are predicted from the past, that is the frames referred to, and from neighbours in
// their own frame that are known by then: the stages come one after the other.
enum PredictionStage : std::size_t {
  first_column = 0,  // of plane 0 (even rows, even columns): the past alone
  coarse = 1,        // its other columns: three neighbours in the column before
  diagonal = 2,      // plane 3 (odd, odd): plane 0 around it
  cross = 3          // planes 1 and 2: planes 0 and 3 around it
};
inline constexpr std::size_t prediction_stage_count = 4;

inline constexpr std::size_t most_near_taps = 4;
inline constexpr std::size_t p_past_taps = 10;
inline constexpr std::size_t b_past_taps = 13;  // the last three only of B frames
inline constexpr std::size_t most_taps = most_near_taps + b_past_taps;

constexpr std::size_t near_taps_of(std::size_t stage) {
  return stage == first_column ? 0 : stage == coarse ? 3 : most_near_taps;
}
constexpr std::size_t past_taps_of(Prediction prediction) {
  return prediction == Prediction::b ? b_past_taps : p_past_taps;
}

struct StageWeights {
  std::array<float, most_near_taps> near{};
  std::array<float, b_past_taps> past{};
};
using Weights = std::array<StageWeights, prediction_stage_count>;

// Weights as they are recorded: whole numbers of 2^-shift.
struct RecordedWeights {
  struct Stage {
    std::array<std::int32_t, most_near_taps> near{};
    std::array<std::int32_t, b_past_taps> past{};
  };
  int shift = 0;
  std::array<Stage, prediction_stage_count> stages{};

  // Visits those that a prediction has, in their order: visit(number).
  template <class Visit>
  void for_each(Prediction prediction, Visit visit);

  [[nodiscard]] Weights weights() const;
};

template <class Visit>
void RecordedWeights::for_each(Prediction prediction, Visit visit) {
  for (std::size_t stage = 0; stage < prediction_stage_count; ++stage) {
    for (std::size_t tap = 0; tap < near_taps_of(stage); ++tap) visit(stages[stage].near[tap]);
    for (std::size_t tap = 0; tap < past_taps_of(prediction); ++tap) visit(stages[stage].past[tap]);
  }
}

// In an intra frame plane 0 continues straight lines; the others lie in the middle of the four
// around them, corrected by two differences with these weights.
struct MiddleWeights {
  float pairs = 0;  // the neighbours along the ribbon against those across it
  float outer = 0;  // four that are further away along the ribbon against the four
};
inline constexpr std::size_t middle_stage_count = 2;  // diagonal, cross
using IntraWeights = std::array<MiddleWeights, middle_stage_count>;

}  // namespace ribbon
