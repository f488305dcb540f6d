// What the geometry that a fuzzer makes is decoded with, and from.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "recording/codec/codec_parameters.h"
#include "recording/codec/position_encoder.h"

namespace ribbon {

// The parameters for a grid: steps of 2^-16 m, or exact single precision.
inline CodecParameters parameters_for(const RibbonGrid& grid, bool uniform) {
  CodecParameters parameters;
  parameters.grid = grid;
  parameters.step_m = uniform ? 0x1p-16F : 0;
  return parameters;
}

// A wave that moves on from turn to turn: 3 x particles, metres.
inline Eigen::Matrix3Xd wave(const RibbonGrid& grid, int turn) {
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  for (int p = 0; p < positions.cols(); ++p)
    positions.col(p) << 0.01 * grid.row(p), 0.01 * grid.column(p),
        0.1 * std::sin(0.1 * (grid.row(p) + turn));
  return positions;
}

inline constexpr double reference_bound_m = 1e-4;

// The first frame of that wave, an intra frame.
inline QuantisedFrame reference_frame(const CodecParameters& parameters) {
  return PositionEncoder(parameters, reference_bound_m)
      .encode(wave(parameters.grid, 0), nullptr)
      .value()
      .frame;
}

}  // namespace ribbon
