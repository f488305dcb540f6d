#include "converter/export/pc2_writer.h"

#include <cstdint>
#include <string>

#include "converter/export/positions_writer.h"
#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

std::string header(Eigen::Index points, int samples) {
  std::string bytes("POINTCACHE2\0", 12);
  put<std::int32_t>(bytes, 1);
  put<std::int32_t>(bytes, static_cast<std::int32_t>(points));
  put<float>(bytes, 0);
  put<float>(bytes, 1);
  put<std::int32_t>(bytes, samples);
  return bytes;
}

}  // namespace

Result<std::unique_ptr<MotionWriter>> new_pc2_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames) {
  return new_positions_writer(path, header(model.objects.front().positions.cols(), frames), model,
                              frames, std::endian::little);
}

}  // namespace ribbon
