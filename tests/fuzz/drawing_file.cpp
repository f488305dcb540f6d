// Whatever the bytes of a drawing, its paths and marks are found or refused with a sentence.
#include <string>

#include "curve/drawing.h"
#include "fuzz/memory_file.h"
#include "fuzz/must.h"

namespace ribbon {
namespace {

constexpr double tolerance = 0.1;

void check_path(const SvgPath& path) {
  const auto drawings = flattened(path, tolerance);
  if (!drawings) return;
  must(!drawings->empty(), "a path that is not refused has pieces");
  for (const Drawing& drawing : *drawings)
    must(extent_of(drawing) < 1e10, "drawings stay within 1e9 units");
}

}  // namespace
}  // namespace ribbon

// libFuzzer gives the name. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ribbon;
  const MemoryFile file("drawing");
  file.append(data, size);
  for (const std::string id : {"", "band"}) {
    const auto paths = find_svg_paths(file.path(), id);
    if (!paths) continue;
    for (const SvgPath& path : *paths) check_path(path);
  }
  if (const auto marks = find_svg_marks(file.path()))
    must(marks->size() <= size, "marks take bytes");
  return 0;
}
