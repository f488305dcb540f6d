#include "model/rate_warnings.h"

#include <algorithm>
#include <cmath>

#include "text/number_text.h"

namespace ribbon {

namespace {

// Of a frame, how far its time is off where it is rounded to single precision.
double time_error(double frames_per_second, int frame) {
  const double time_s = frame / frames_per_second;
  return std::abs(static_cast<double>(static_cast<float>(time_s)) - time_s) * frames_per_second;
}

}  // namespace

std::string whole_rate_warning(const Model& model, int frames) {
  const double rate = model.frames_per_second;
  if (frames == 1 || rate == std::round(rate)) return "";
  return filled_in("Blender plays {} frames a second as {:.0f}", short_number(rate), rate);
}

std::string rounded_time_warning(const Model& model, int frames) {
  constexpr double visible = 0.001;
  double largest = 0;
  for (int frame = 0; frame < frames; ++frame)
    largest = std::max(largest, time_error(model.frames_per_second, frame));
  if (largest <= visible) return "";
  return filled_in("times in single precision are off by up to {:.1f} % of a frame", 100 * largest);
}

std::string joined_warnings(const std::string& one, const std::string& other) {
  return one + (one.empty() || other.empty() ? "" : "; ") + other;
}

}  // namespace ribbon
