// Colours that stand for numbers, in steps that look equally large.
#pragma once

#include <span>
#include <vector>

#include "player/picture/color.h"

namespace ribbon {

// CIE L*a*b* under the white of sRGB: distances in it are about as large as they look. lightness
// runs from 0, black, to 100, white.
struct LabColor {
  float lightness;
  float green_red;
  float blue_yellow;
};

Color linear_light(const LabColor& lab);

class ColorMap {
 public:
  // A smooth path through the stations, at least two, at an even pace: from place to place the
  // colour changes by the same distance everywhere.
  explicit ColorMap(std::span<const LabColor> stations);
  // One map from 0 to 0.5, the other from there on.
  ColorMap(const ColorMap& first, const ColorMap& second);

  // place: 0 to 1; beyond it is the colour of that end, and of the low one what is no number.
  [[nodiscard]] Color at(float place) const;

  // The same colours from the other end.
  [[nodiscard]] ColorMap reversed() const;

 private:
  std::vector<Color> colors_;  // evenly spread
};

// From dark blue over green to pale yellow, ever lighter: right also where colours are not told
// apart or a picture is printed grey.
const ColorMap& sequential_map();
// Orange and blue, equally dark, on the two sides of a pale middle.
const ColorMap& diverging_map();

}  // namespace ribbon
