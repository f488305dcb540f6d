#include "benchmarks/codec/integers.h"

#include <bit>
#include <cassert>
#include <cmath>

#include "geometry/single_precision.h"

// Our own codec picks its instructions while it runs; what is put around the others can as well.
#define RIBBON_CLONED __attribute__((target_clones("avx2", "default")))

namespace ribbon {

namespace {

// What is added to residuals that are not zigzag.
std::uint32_t shift_of(SignForm sign) {
  return sign == SignForm::biased ? 0x80808080U : 0U;
}

// Negative numbers counted from the other end; twice gives the same again.
std::uint32_t turned(std::uint32_t bits) {
  constexpr std::uint32_t all_but_sign = 0x7FFFFFFF;
  return bits ^ ((0U - (bits >> 31U)) & all_but_sign);
}

std::uint32_t zigzag(std::uint32_t residual) {
  return (residual << 1U) ^ (0U - (residual >> 31U));
}

std::uint32_t from_zigzag(std::uint32_t number) {
  return (number >> 1U) ^ (0U - (number & 1U));
}

// A frame is foretold as by_last * last + by_older * older.
struct Foretold {
  const std::uint32_t* last;
  const std::uint32_t* older;
  std::uint32_t by_last;
  std::uint32_t by_older;
};

// The first frame of all has none before it, the second no motion before it.
Foretold foretold(std::span<const std::uint32_t> integers, std::size_t frame,
                  const ResidualForm& form) {
  const std::uint32_t* here = integers.data() + frame * form.frame_values;
  if (frame == 0 || form.difference == TimeDifference::none) return {here, here, 0, 0};
  const std::uint32_t* last = here - form.frame_values;
  if (frame == 1 || form.difference == TimeDifference::first) return {last, last, 1, 0};
  return {last, last - form.frame_values, 2, 0U - 1U};
}

RIBBON_CLONED void subtract(const std::uint32_t* values, Foretold by, SignForm sign,
                            std::size_t count, std::uint32_t* residuals) {
  const std::uint32_t middle = shift_of(sign);
  if (sign == SignForm::zigzag)
    for (std::size_t i = 0; i < count; ++i)
      residuals[i] = zigzag(values[i] - by.by_last * by.last[i] - by.by_older * by.older[i]);
  else
    for (std::size_t i = 0; i < count; ++i)
      residuals[i] = values[i] - by.by_last * by.last[i] - by.by_older * by.older[i] + middle;
}

RIBBON_CLONED void add(const std::uint32_t* residuals, Foretold by, SignForm sign,
                       std::size_t count, std::uint32_t* values) {
  const std::uint32_t middle = shift_of(sign);
  if (sign == SignForm::zigzag)
    for (std::size_t i = 0; i < count; ++i)
      values[i] = from_zigzag(residuals[i]) + by.by_last * by.last[i] + by.by_older * by.older[i];
  else
    for (std::size_t i = 0; i < count; ++i)
      values[i] = residuals[i] - middle + by.by_last * by.last[i] + by.by_older * by.older[i];
}

RIBBON_CLONED void scale_down(const float* floats, double per_step, std::size_t count,
                              std::uint32_t* integers) {
  for (std::size_t i = 0; i < count; ++i) {
    const double steps = floats[i] * per_step;
    integers[i] =
        static_cast<std::uint32_t>(static_cast<std::int32_t>(steps + std::copysign(0.5, steps)));
  }
}

RIBBON_CLONED void scale_up(const std::uint32_t* integers, float step, std::size_t count,
                            float* floats) {
  for (std::size_t i = 0; i < count; ++i)
    floats[i] = static_cast<float>(static_cast<std::int32_t>(integers[i])) * step;
}

RIBBON_CLONED void part(const std::uint32_t* values, std::size_t count, unsigned char* planes) {
  for (std::size_t plane = 0; plane < 4; ++plane)
    for (std::size_t i = 0; i < count; ++i)
      planes[plane * count + i] = static_cast<unsigned char>(values[i] >> (8 * plane));
}

RIBBON_CLONED void join(const unsigned char* planes, std::size_t count, std::uint32_t* values) {
  for (std::size_t i = 0; i < count; ++i)
    values[i] = planes[i] | static_cast<std::uint32_t>(planes[count + i]) << 8U |
                static_cast<std::uint32_t>(planes[2 * count + i]) << 16U |
                static_cast<std::uint32_t>(planes[3 * count + i]) << 24U;
}

}  // namespace

std::optional<float> quantisation_step(const CodecTask& task) {
  if (task.bound_m == 0) return 0.0F;
  // The product of step and value is rounded by at most half of its last place.
  const double step = 2 * (task.bound_m - largest_rounding(task.largest_m + task.bound_m));
  if (step <= 0) return std::nullopt;
  return std::nextafter(static_cast<float>(step), 0.0F);
}

void to_integers(std::span<const float> floats, float step, std::span<std::uint32_t> integers) {
  assert(floats.size() == integers.size());
  if (step != 0) return scale_down(floats.data(), 1.0 / step, floats.size(), integers.data());
  for (std::size_t i = 0; i < floats.size(); ++i)
    integers[i] = turned(std::bit_cast<std::uint32_t>(floats[i]));
}

void to_floats(std::span<const std::uint32_t> integers, float step, std::span<float> floats) {
  assert(integers.size() == floats.size());
  if (step != 0) return scale_up(integers.data(), step, integers.size(), floats.data());
  for (std::size_t i = 0; i < integers.size(); ++i)
    floats[i] = std::bit_cast<float>(turned(integers[i]));
}

void to_residuals(std::span<const std::uint32_t> integers, const ResidualForm& form,
                  std::span<std::uint32_t> residuals) {
  for (std::size_t frame = 0; frame * form.frame_values < integers.size(); ++frame)
    subtract(&integers[frame * form.frame_values], foretold(integers, frame, form), form.sign,
             form.frame_values, &residuals[frame * form.frame_values]);
}

void undo_residuals(std::span<const std::uint32_t> residuals, const ResidualForm& form,
                    std::span<std::uint32_t> integers) {
  for (std::size_t frame = 0; frame * form.frame_values < integers.size(); ++frame)
    add(&residuals[frame * form.frame_values], foretold(integers, frame, form), form.sign,
        form.frame_values, &integers[frame * form.frame_values]);
}

void part_bytes(std::span<const std::uint32_t> values, std::span<unsigned char> planes) {
  assert(planes.size() == 4 * values.size());
  part(values.data(), values.size(), planes.data());
}

void join_bytes(std::span<const unsigned char> planes, std::span<std::uint32_t> values) {
  assert(planes.size() == 4 * values.size());
  join(planes.data(), values.size(), values.data());
}

}  // namespace ribbon
