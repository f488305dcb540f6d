// A frame of the sample as the exporters get it.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "converter/export/model.h"
#include "converter/export/picture_file.h"
#include "converter/sample_knot.h"
#include "converter/sample_picture.h"

namespace ribbon {

inline Model posed_model(const SampleKnot& knot, std::size_t frame,
                         const ModelSettings& settings = {}) {
  Model model = model_of_recording(knot.header, settings).value();
  const Eigen::Matrix3Xf positions = knot.frames.at(frame).cast<float>();
  EXPECT_TRUE(pose_ribbon(model, positions, static_cast<int>(frame) + 1).has_value());
  return model;
}

// A picture of 2 x 1 pixels lies on the ribbon.
inline ModelSettings textured() {
  return {.picture = std::make_shared<const PictureFile>(PictureFile{.bytes = sample_png(),
                                                                     .media_type = "image/png",
                                                                     .extension = ".png",
                                                                     .width = 2,
                                                                     .height = 1,
                                                                     .name = "knot.png"})};
}

}  // namespace ribbon
