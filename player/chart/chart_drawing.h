// A drawing of lines and words, before it becomes a file of one kind or another.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "player/picture/picture.h"

namespace ribbon {

// Places and lengths are in pixels of the drawing, from its top left corner; colours are 0xRRGGBB.
struct DrawnLine {
  std::vector<Eigen::Vector2f> points;  // one is a dot
  std::uint32_t color = 0;
  float width = 1;
  bool dashed = false;
};

struct DrawnBox {
  Eigen::Vector2f low;
  Eigen::Vector2f high;
  std::uint32_t color = 0;
};

enum class TextAnchor { start, middle, end };

struct DrawnText {
  Eigen::Vector2f place;  // on the baseline
  std::string text;       // UTF-8
  int height = 12;
  TextAnchor anchor = TextAnchor::start;
  std::uint32_t color = 0;
};

struct ChartDrawing {
  PictureSize size;
  std::string title;  // told by programs that show the drawing, not drawn
  std::vector<std::variant<DrawnBox, DrawnLine, DrawnText>> shapes;  // later ones lie on top
};

// As SVG, whatever characters the texts hold.
std::string svg_text(const ChartDrawing& drawing);

// As pixels, `scale` of them for each of the drawing's.
Picture painted(const ChartDrawing& drawing, int scale);

}  // namespace ribbon
