// The weights of a prediction (FORMAT.md, section 8.3).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace ribbon {

// What a frame is predicted from.
enum class Prediction : std::uint8_t {
  within = 0,   // itself alone
  forward = 1,  // up to three frames before it, the nearest first
  between = 2   // the frame before and the one after it, then the next ones outwards
};

// Particles are predicted from the past, that is the frames referred to, and from neighbours in
// their own frame that are known by then: the stages come one after the other.
enum PredictionStage : std::size_t {
  coarse_past = 0,      // plane 0 (even rows, even columns): the past of all its particles,
  coarse_diagonal = 1,  // then, in its odd rows and columns, what the past missed at the diagonals,
  coarse_cross = 2,     // and in the rest of it what the past missed at the four neighbours
  diagonal = 3,         // plane 3 (odd, odd): the past, and plane 0 around it
  cross = 4             // planes 1 and 2: the past, and planes 0 and 3 around it
};
inline constexpr std::size_t prediction_stage_count = 5;

inline constexpr std::size_t near_taps = 4;
inline constexpr std::size_t past_taps = 15;  // the last three only between two frames
inline constexpr std::size_t forward_past_taps = 12;
inline constexpr std::size_t most_taps = near_taps + past_taps;

// Of each stage: the weights of the neighbours, then those of the past. Unused ones are 0.
using StageWeights = std::array<float, most_taps>;
using Weights = std::array<StageWeights, prediction_stage_count>;

// Does `stage` look at neighbours, and at the past?
constexpr bool has_near_taps(std::size_t stage) {
  return stage != coarse_past;
}
constexpr bool has_past_taps(std::size_t stage) {
  return stage != coarse_diagonal && stage != coarse_cross;
}
constexpr std::size_t past_taps_of(Prediction prediction) {
  return prediction == Prediction::between ? past_taps : forward_past_taps;
}

// Weights as they are recorded: whole numbers of 2^-shift.
struct RecordedWeights {
  int shift = 0;
  std::array<std::array<std::int32_t, most_taps>, prediction_stage_count> numbers{};

  // Visits those that a prediction has, by stage and tap: visit(number).
  template <class Visit>
  void for_each(Prediction prediction, Visit visit);

  [[nodiscard]] Weights weights() const;
};

template <class Visit>
void RecordedWeights::for_each(Prediction prediction, Visit visit) {
  for (std::size_t stage = 0; stage < prediction_stage_count; ++stage) {
    const std::size_t first = has_near_taps(stage) ? 0 : near_taps;
    const std::size_t end = near_taps + (has_past_taps(stage) ? past_taps_of(prediction) : 0);
    for (std::size_t tap = first; tap < end; ++tap) visit(numbers[stage][tap]);
  }
}

// Within a frame plane 0 continues straight lines; the others lie in the middle of the four around
// them, corrected by two differences with these weights.
struct MiddleWeights {
  float pairs = 0;  // the neighbours along the ribbon against those across it
  float outer = 0;  // four that are further away along the ribbon against the four
};
inline constexpr std::size_t middle_stage_count = 2;  // diagonal, cross
using WithinWeights = std::array<MiddleWeights, middle_stage_count>;

}  // namespace ribbon
