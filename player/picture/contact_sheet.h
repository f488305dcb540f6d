// Several frames side by side, as in the paper's Figures 16 and 18.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "player/picture/legend.h"
#include "player/picture/picture.h"
#include "recording/records/recording.h"

namespace ribbon {

// One moment: its pictures, one per camera, stand above each other.
struct SheetColumn {
  int frame_number = 1;  // as users see it, from 1
  FrameNumbers numbers;
  std::vector<Picture> views;
  std::string stage = {};  // of the fastening; empty: none
};

inline constexpr PictureSize sheet_cell{520, 300};

// All columns must have the same number of views, each of size sheet_cell; at least one column. A
// legend stands beside the title. Words that find no room are written smaller, or shortened.
Picture contact_sheet(const std::string& title, const std::string& subtitle,
                      const std::vector<SheetColumn>& columns,
                      const std::optional<Legend>& legend = std::nullopt);

// What stands under a column: two lines.
std::vector<std::string> sheet_caption(int frame_number, const FrameNumbers& numbers,
                                       const std::string& stage = {});

// At most `most` (at least 2) of the frames, evenly spread, the first and the last among them.
std::vector<int> spread_frames(const std::vector<int>& frames, int most);

}  // namespace ribbon
