#include "converter/export/npy_writer.h"

#include <cstdint>
#include <string>

#include "converter/export/positions_writer.h"
#include "recording/coding/bytes.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr std::size_t alignment = 64;

std::string header(const RibbonGrid& grid, int frames) {
  std::string bytes("\x93NUMPY\x01\x00", 8);
  std::string dictionary = "{'descr': '<f4', 'fortran_order': False, 'shape': (" +
                           filled_in("{}, {}, {}, 3", frames, grid.along, grid.across) + "), }";
  const std::size_t size = bytes.size() + sizeof(std::uint16_t) + dictionary.size() + 1;
  dictionary.append((alignment - size % alignment) % alignment, ' ');
  dictionary += '\n';
  put<std::uint16_t>(bytes, static_cast<std::uint16_t>(dictionary.size()));
  return bytes + dictionary;
}

}  // namespace

Result<std::unique_ptr<MotionWriter>> new_npy_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames) {
  if (model.objects.front().positions.cols() != model.grid.particle_count())
    return failure(path.string(),
                   "an array holds the ribbon's particles, and a solid has more points",
                   "leave --thickness out");
  return new_positions_writer(path, header(model.grid, frames), model, frames, std::endian::little);
}

}  // namespace ribbon
