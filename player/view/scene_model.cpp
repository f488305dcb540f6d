#include "player/view/scene_model.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

float model_scale(const RecordingHeader& header) {
  constexpr int largest = 126;  // of the powers whose inverse is a number of full precision, too
  double size_m = header.ribbon_length_m;
  if (header.obstacle && header.obstacle->vertices.cols() > 0) {
    const Eigen::Matrix3Xf& vertices = header.obstacle->vertices;
    const Eigen::Vector3f extent = vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff();
    size_m = std::max(size_m, static_cast<double>(extent.maxCoeff()));
  }
  int exponent = 0;
  std::frexp(size_m, &exponent);  // 1 for a size from 1 to 2
  return std::ldexp(1.0F, std::clamp(1 - exponent, -largest, largest));
}

RecordingHeader model_of(RecordingHeader header) {
  const float scale = model_scale(header);
  header.ribbon_length_m *= scale;
  header.ribbon_width_m *= scale;
  if (header.obstacle) header.obstacle->vertices *= scale;
  header.input_curve *= scale;
  return header;
}

}  // namespace ribbon
