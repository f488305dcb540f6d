// The loops over all particles that decide how fast a recording is read and written. Only sums,
// differences and products in single precision, each rounded by itself and in a fixed order, and
// whole numbers modulo 2^32: every compiler and processor gets the same bits. Compiled once for
// each instruction set, so that particles lie side by side in its registers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "recording/parity_planes.h"
#include "recording/prediction.h"

namespace ribbon {

// One component of a frame while it is predicted; all by cell but the ranks.
struct Component {
  const ParityPlanes* planes = nullptr;
  Prediction prediction = Prediction::within;
  bool on_lattice = true;  // false: numbers are ordered_number() of the values
  // The first frame referred to and the past; none of them within a frame.
  const float* reference_values = nullptr;
  const std::int32_t* reference_numbers = nullptr;
  const PastFields* past = nullptr;
  const Weights* weights = nullptr;
  const WithinWeights* within_weights = nullptr;
  // Of this frame.
  std::int32_t* numbers = nullptr;
  float* values = nullptr;  // the numbers in single precision; borders are not set
  float* motion = nullptr;  // its values less those of the first frame referred to
  float* missed = nullptr;  // working memory
  float* predicted = nullptr;
  // How far the numbers are from their prediction, plane by plane in the order 0, 3, 1, 2, each
  // row by row, without borders: 0 for the number nearest to it, 1 for the second nearest, ...
  std::uint32_t* ranks = nullptr;
};

struct Loops {
  void (*subtract)(const float* a, const float* b, std::size_t count, float* difference);
  // The pull of the springs to the neighbours (di, dj) away and to those opposite: each edge times
  // (its squared length / rest_squared - 1). edge_pull: working memory, zero where no edge begins.
  void (*pull)(const ParityPlanes& planes, int di, int dj, float rest_squared,
               const std::array<const float*, 3>& values, const std::array<float*, 3>& edge_pull,
               const std::array<float*, 3>& pull);
  // Gives the border of a plane what decode() and rank() give it: the values of its nearest cells,
  // or within a frame what continues straight lines.
  void (*close_plane)(const ParityPlanes& planes, int plane, float* field);
  void (*continue_plane)(const ParityPlanes& planes, int plane, float* field);
  // Numbers, values and motion from ranks.
  void (*decode)(const Component& component);
  // Ranks from numbers and motion.
  void (*rank)(const Component& component);
  // Interleaves the coordinates: positions is 3 x particles, column by column.
  void (*positions)(const ParityPlanes& planes, const std::array<const std::int32_t*, 3>& numbers,
                    float step_m, float* positions);
};

enum class InstructionSet { baseline, avx2, avx512 };

// The loops for an instruction set; null where this processor or build does not have it.
const Loops* loops_for(InstructionSet set);

// Those for the best set that there is, or the one chosen last.
const Loops& loops();

// The best set that this processor has.
InstructionSet best_instruction_set();

// For tests and measurements: all are to give the same bits. Not while others read or write.
void choose_instruction_set(InstructionSet set);

}  // namespace ribbon
