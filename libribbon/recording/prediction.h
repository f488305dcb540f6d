// What a frame is predicted from, made ready (FORMAT.md, section 8.3).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "recording/codec_parameters.h"
#include "recording/lattice_frame.h"
#include "recording/parity_planes.h"
#include "recording/prediction_weights.h"

namespace ribbon {

// What is known of one component when a frame comes, by cell.
struct PastFields {
  std::vector<float> motion;  // from the second frame referred to, to the first
  std::vector<float> second_motion;
  std::vector<float> third_motion;
  // The pull of stretched springs at each particle in the first frame, and in the second.
  std::vector<float> along_pull;
  std::vector<float> across_pull;
  std::vector<float> second_along_pull;
  std::vector<float> second_across_pull;
};

// The frames referred to, made ready. Keeps its memory between frames.
class Past {
 public:
  explicit Past(const CodecParameters& parameters);

  // references: at least one, none of them plain; they must live as long as this is used.
  void set(Prediction prediction, std::span<const LatticeFrame* const> references);

  [[nodiscard]] const LatticeFrame& first() const { return *first_; }
  [[nodiscard]] const PastFields& fields(std::size_t component) const { return fields_[component]; }

 private:
  using Field = std::vector<float> PastFields::*;
  void set_motion(Field field, const LatticeFrame* to, const LatticeFrame* from);
  void set_pulls(Field along, Field across, const LatticeFrame& frame);
  void set_pull(Field field, int di, int dj, float rest_squared, PlaneFields<float>& edge_pulls,
                const LatticeFrame& frame);

  ParityPlanes planes_;
  float along_rest_squared_ = 0;  // natural distance of neighbours, in the unit of the values
  float across_rest_squared_ = 0;
  const LatticeFrame* first_ = nullptr;
  std::array<PastFields, 3> fields_;
  // Working memory, each zero where no edge of its direction begins.
  PlaneFields<float> along_edge_pull_;
  PlaneFields<float> across_edge_pull_;
};

}  // namespace ribbon
