// What a picture's corner tells about its frame.
#pragma once

#include <string>
#include <vector>

#include "player/overlay/overlays.h"
#include "player/picture/caption.h"
#include "player/picture/picture.h"
#include "recording/records/recording.h"

namespace ribbon {

// The lines of the caption. frame: counted from 1; one that lies between two is told to be
// interpolated. stage: its name, empty where there is none.
std::vector<std::string> frame_caption(const Overlays& overlays, double frame,
                                       const FrameNumbers& numbers, const std::string& stage = {});

// In the upper left corner, as large as suits the picture's height; lines that are too long for it
// are shortened. Nothing without lines.
void draw_caption(const std::vector<std::string>& lines, const CaptionPainter& painter,
                  Picture& picture);

}  // namespace ribbon
