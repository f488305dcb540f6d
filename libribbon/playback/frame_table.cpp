#include "playback/frame_table.h"

#include <algorithm>

namespace ribbon {

void FrameTable::extend(std::uint32_t size) {
  size_ = std::max(size_, size);
}

const IndexedFrame* FrameTable::find(std::uint32_t frame) const {
  const std::size_t page = frame / page_frames;
  if (page >= pages_.size() || !pages_[page]) return nullptr;
  const auto& entry = (*pages_[page])[frame % page_frames];
  return entry ? &*entry : nullptr;
}

bool FrameTable::insert(const IndexedFrame& frame) {
  const std::size_t page = frame.frame / page_frames;
  if (page >= pages_.size()) pages_.resize(page + 1);
  if (!pages_[page]) pages_[page] = std::make_unique<Page>();
  auto& entry = (*pages_[page])[frame.frame % page_frames];
  if (entry) return false;
  entry = frame;
  extend(frame.frame + 1);
  return true;
}

void FrameTable::replace(const IndexedFrame& frame) {
  (*pages_[frame.frame / page_frames])[frame.frame % page_frames] = frame;
}

}  // namespace ribbon
