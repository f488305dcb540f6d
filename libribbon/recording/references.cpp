#include "recording/references.h"

#include <algorithm>

namespace ribbon {

std::vector<std::uint32_t> live_references(std::uint32_t frame) {
  std::vector<std::uint32_t> references;
  const std::uint32_t before = std::min<std::uint32_t>(frame % live_group_frames, 3);
  for (std::uint32_t back = 1; back <= before; ++back) references.push_back(frame - back);
  return references;
}

}  // namespace ribbon
