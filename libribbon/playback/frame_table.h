// Frames by their number.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "recording/records/index_record.h"

namespace ribbon {

// In pages, so that a table of a long recording of which little is known yet is small, and what
// has been found in it never moves.
class FrameTable {
 public:
  static constexpr std::uint32_t page_frames = 256;

  // One more than the highest number that is known to exist.
  [[nodiscard]] std::uint32_t size() const { return size_; }
  // Frames up to `size` exist, even where nothing else is known of them.
  void extend(std::uint32_t size);

  // Nothing where the frame is not known; valid as long as the table lives.
  [[nodiscard]] const IndexedFrame* find(std::uint32_t frame) const;

  // False, changing nothing, where that frame is known already.
  bool insert(const IndexedFrame& frame);
  // Likewise of a frame that is known; what find() gave is that of the new one then.
  void replace(const IndexedFrame& frame);

 private:
  using Page = std::array<std::optional<IndexedFrame>, page_frames>;
  std::vector<std::unique_ptr<Page>> pages_;
  std::uint32_t size_ = 0;
};

}  // namespace ribbon
