// Numbers of four systems that are computed side by side, each in its lane: the same bits whether
// the processor has registers for four, for two or for one.
#pragma once

#include <array>
#include <cstddef>

namespace ribbon {

using Four [[gnu::vector_size(4 * sizeof(double))]] = double;

// In memory: the compiler believes in an alignment that it gives Four only where registers are so
// wide.
template <std::size_t count>
struct alignas(4 * sizeof(double)) Fours : std::array<Four, count> {};

using FourVectors = Fours<3>;
using FourBlocks = std::array<FourVectors, 3>;  // 3 x 3, row by row

}  // namespace ribbon
