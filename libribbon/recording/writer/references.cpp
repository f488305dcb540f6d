#include "recording/writer/references.h"

#include <algorithm>

namespace ribbon {

ReferenceList references_of(std::uint32_t frame) {
  ReferenceList references;
  const auto count = std::min<std::uint32_t>(frame % group_frames, most_references);
  for (std::uint32_t back = 1; back <= count; ++back) references.push_back(frame - back);
  return references;
}

}  // namespace ribbon
