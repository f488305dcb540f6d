// What is exported: the ribbon and the obstacle as named objects with faces, uv and a material.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "recording/records/recording.h"
#include "result/result.h"

namespace ribbon {

struct Material {
  std::string name;
  Eigen::Vector3f color;  // linear, 0 to 1
};

struct ModelObject {
  std::string name;  // one line, not empty, at most 63 bytes; unique in its model
  Material material;
  Eigen::Matrix3Xf positions;  // 3 x vertices in metres, y up
  Eigen::Matrix2Xf uv;         // 2 x vertices, or 2 x 0: the object has none
  Eigen::MatrixXi faces;       // corners x faces, counter-clockwise seen from the front
};

struct Model {
  std::vector<ModelObject> objects;  // the ribbon first
  double frames_per_second = 0;
};

// The parts of the model that no frame changes. The ribbon's positions are still to be set. Fails
// when the header contradicts itself: uv or face indices that do not fit, an obstacle that is not
// finite.
Result<Model> model_of_recording(const RecordingHeader& header, bool with_obstacle);

// Puts one frame's ribbon (3 x particles, metres) into `model`. Fails, naming the frame (`number`
// from 1), when the number of particles differs from the recording's or a position is not finite.
Result<void> pose_ribbon(Model& model, const Eigen::Matrix3Xf& positions, int number);

}  // namespace ribbon
