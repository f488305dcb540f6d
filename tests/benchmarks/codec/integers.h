// Coordinates as integers and as differences in time, for codecs that know nothing of either. All
// arithmetic is modulo 2^32.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "benchmarks/codec/frame_codec.h"

namespace ribbon {

// The quantisation step, a single-precision number, so that the nearest value, rounded to single
// precision, is within the bound. 0, which stands for the bits of the floats, where the bound is 0;
// nothing where floats are too coarse for it.
std::optional<float> quantisation_step(const CodecTask& task);

// The nearest quantised values. With step 0 the bits of the floats, turned so that they are ordered
// as the floats are.
void to_integers(std::span<const float> floats, float step, std::span<std::uint32_t> integers);

// And back.
void to_floats(std::span<const std::uint32_t> integers, float step, std::span<float> floats);

// How a value is foretold from the same coordinate in the frames before: not at all, as it was in
// the last one, or as if it went on as it went.
enum class TimeDifference { none, first, second };

// How a residual of either sign becomes bytes that are much alike: 0, -1, 1, -2, ... as 0, 1, 2, 3,
// ..., or all shifted so that 0 is in the middle of what each byte holds; or plainly as it is.
enum class SignForm { zigzag, biased, plain };

struct ResidualForm {
  std::size_t frame_values = 0;  // in each frame
  TimeDifference difference = TimeDifference::none;
  SignForm sign = SignForm::zigzag;
};

// integers, residuals: whole frames, equally many.
void to_residuals(std::span<const std::uint32_t> integers, const ResidualForm& form,
                  std::span<std::uint32_t> residuals);

// And back.
void undo_residuals(std::span<const std::uint32_t> residuals, const ResidualForm& form,
                    std::span<std::uint32_t> integers);

// Puts the bytes of the same weight together: four planes of values.size() bytes each.
void part_bytes(std::span<const std::uint32_t> values, std::span<unsigned char> planes);

// And back.
void join_bytes(std::span<const unsigned char> planes, std::span<std::uint32_t> values);

}  // namespace ribbon
