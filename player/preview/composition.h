// What was drawn, before the backdrop.
#pragma once

#include <cstdint>
#include <vector>

#include "player/picture/picture.h"

namespace ribbon {

// A part of a picture.
struct PicturePart {
  int left = 0;
  int bottom = 0;  // pixels below it
  PictureSize size;
};

// drawn: four bytes a pixel, square roots of red, green and blue, multiplied by the opacity, then
// that; row by row from the bottom. Lays them over the backdrop and puts them into their part of
// `picture`.
void compose(const std::vector<std::uint8_t>& drawn, const PicturePart& part, Picture& picture);

}  // namespace ribbon
