#include "converter/export/mdd_writer.h"

#include <Eigen/Core>
#include <string>

#include "converter/export/positions_writer.h"
#include "model/raw_bytes.h"

namespace ribbon {

namespace {

std::string header(Eigen::Index points, int frames, double frames_per_second) {
  Eigen::Array2i counts(frames, static_cast<int>(points));
  Eigen::ArrayXf times =
      (Eigen::ArrayXd::LinSpaced(frames, 0, frames - 1) / frames_per_second).cast<float>();
  swap_bytes(counts);
  swap_bytes(times);
  return std::string(raw_bytes(counts)).append(raw_bytes(times));
}

}  // namespace

Result<std::unique_ptr<MotionWriter>> new_mdd_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames) {
  const Eigen::Index points = model.objects.front().positions.cols();
  return new_positions_writer(path, header(points, frames, model.frames_per_second), model, frames,
                              std::endian::big);
}

}  // namespace ribbon
