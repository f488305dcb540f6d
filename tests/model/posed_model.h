// A frame of the sample as the exporters get it.
#pragma once

#include <gtest/gtest.h>

#include "model/model.h"
#include "model/sample_knot.h"
#include "model/textured_settings.h"

namespace ribbon {

inline Model posed_model(const SampleKnot& knot, std::size_t frame,
                         const ModelSettings& settings = {}) {
  Model model = model_of_recording(knot.header, settings).value();
  const Eigen::Matrix3Xf positions = knot.frames.at(frame).cast<float>();
  EXPECT_TRUE(pose_ribbon(model, positions, static_cast<int>(frame) + 1).has_value());
  return model;
}

// The sample without what a solid cannot be raised from: its obstacle and the pinched frame.
inline SampleKnot knot_with_room() {
  SampleKnot knot = sample_knot();
  knot.header.obstacle.reset();
  knot.frames.erase(knot.frames.begin() + 2);
  return knot;
}

}  // namespace ribbon
