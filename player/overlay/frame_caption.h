// What a picture's corner tells about its frame.
#pragma once

#include <string>
#include <vector>

#include "player/overlay/overlays.h"
#include "player/picture/caption.h"
#include "player/picture/picture.h"
#include "recording/records/recording.h"

namespace ribbon {

// The lines of the caption; frame_number counts from 1. stage: its name, empty where there is none.
std::vector<std::string> frame_caption(const Overlays& overlays, int frame_number,
                                       const FrameNumbers& numbers, const std::string& stage = {});

// In the upper left corner, as large as suits the picture's height. Nothing without lines.
void draw_caption(const std::vector<std::string>& lines, const CaptionPainter& painter,
                  Picture& picture);

}  // namespace ribbon
