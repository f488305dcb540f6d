// Tells in a picture which colour stands for which value.
#pragma once

#include <string>
#include <vector>

#include "player/picture/caption.h"
#include "player/picture/color_map.h"
#include "player/picture/picture.h"

namespace ribbon {

struct LegendMark {
  float place;  // on the map, 0 to 1
  std::string text;
};

struct Legend {
  std::string title;  // what is measured, and its unit
  ColorMap map;
  std::vector<LegendMark> marks;  // ascending; inner ones that find no room are left out
  // The marks are all the values that there are: each has a field of its own colour.
  bool fields = false;
};

// What a legend takes whose letters are that high.
PictureSize legend_size(int text_height);

// With its upper left corner at (left, top).
void draw_legend(const Legend& legend, int left, int top, int text_height,
                 const CaptionPainter& painter, Picture& picture);

// In the picture's lower left corner, as large as suits it, where the picture shines through.
void draw_corner_legend(const Legend& legend, const CaptionPainter& painter, Picture& picture);

// How high letters are in pictures of that size.
int picture_text_height(PictureSize size);

}  // namespace ribbon
