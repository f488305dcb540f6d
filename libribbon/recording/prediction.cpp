#include "recording/prediction.h"

#include <algorithm>
#include <cassert>

#include "recording/component_loops.h"

namespace ribbon {

namespace {

float squared(double length) {
  return static_cast<float>(length * length);
}

}  // namespace

Past::Past(const CodecParameters& parameters) : planes_(parameters.grid) {
  const double unit_m = parameters.step_m > 0 ? static_cast<double>(parameters.step_m) : 1;
  along_rest_squared_ = squared(parameters.ribbon_length_m / (parameters.grid.along - 1) / unit_m);
  across_rest_squared_ = squared(parameters.ribbon_width_m / (parameters.grid.across - 1) / unit_m);
  for (auto* edge_pull : {&along_edge_pull_, &across_edge_pull_})
    for (auto& component : *edge_pull) component.assign(planes_.cells(), 0);
}

void Past::set(Prediction prediction, std::span<const LatticeFrame* const> references) {
  assert(!references.empty() && prediction != Prediction::within);
  const auto reference = [&](std::size_t k) {
    return k < references.size() ? references[k] : nullptr;
  };
  first_ = reference(0);
  set_motion(&PastFields::motion, first_, reference(1));
  set_pulls(&PastFields::along_pull, &PastFields::across_pull, *first_);
  if (prediction == Prediction::forward) {
    set_motion(&PastFields::second_motion, reference(1), reference(2));
    return;
  }
  set_motion(&PastFields::second_motion, first_, reference(2));
  set_motion(&PastFields::third_motion, reference(3), reference(1));
  set_pulls(&PastFields::second_along_pull, &PastFields::second_across_pull,
            *(reference(1) != nullptr ? reference(1) : first_));
}

// Nothing has moved where a frame is missing.
void Past::set_motion(Field field, const LatticeFrame* to, const LatticeFrame* from) {
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<float>& motion = fields_[c].*field;
    motion.resize(planes_.cells());
    if (to == nullptr || from == nullptr)
      std::fill(motion.begin(), motion.end(), 0.0F);
    else
      loops().subtract(to->values[c].data(), from->values[c].data(), motion.size(), motion.data());
  }
}

void Past::set_pulls(Field along, Field across, const LatticeFrame& frame) {
  set_pull(along, 1, 0, along_rest_squared_, along_edge_pull_, frame);
  set_pull(across, 0, 1, across_rest_squared_, across_edge_pull_, frame);
}

void Past::set_pull(Field field, int di, int dj, float rest_squared, PlaneFields<float>& edge_pulls,
                    const LatticeFrame& frame) {
  std::array<const float*, 3> values{};
  std::array<float*, 3> edge_pull{};
  std::array<float*, 3> pull{};
  for (std::size_t c = 0; c < 3; ++c) {
    (fields_[c].*field).resize(planes_.cells());
    values[c] = frame.values[c].data();
    edge_pull[c] = edge_pulls[c].data();
    pull[c] = (fields_[c].*field).data();
  }
  loops().pull(planes_, di, dj, rest_squared, values, edge_pull, pull);
}

}  // namespace ribbon
