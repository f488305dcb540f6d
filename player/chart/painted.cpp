#include <algorithm>
#include <cmath>

#include "player/chart/chart_drawing.h"
#include "player/picture/caption.h"
#include "player/picture/page_colors.h"
#include "player/picture/strokes.h"

namespace ribbon {

namespace {

constexpr float dash = 4;  // drawn, and left out

class DrawingPainter {
 public:
  DrawingPainter(PictureSize size, int scale)
      : scale_(scale),
        picture_(blank_picture({size.width * scale, size.height * scale}, page_paper)) {}

  void paint(const DrawnBox& box) {
    const Eigen::Vector2i low = pixel(box.low).array().round().matrix().cast<int>();
    const Eigen::Vector2i high = pixel(box.high).array().round().matrix().cast<int>();
    fill({low.x(), low.y(), high.x(), high.y()}, from_srgb(box.color), 1, picture_);
  }

  void paint(const DrawnLine& line) {
    Strokes strokes(picture_.size);
    const float width = line.width * static_cast<float>(scale_);
    if (line.points.size() == 1) {
      strokes.add(pixel(line.points[0]), pixel(line.points[0]), 2 * width);
    }
    for (std::size_t k = 0; k + 1 < line.points.size(); ++k) {
      if (line.dashed)
        add_dashes(line.points[k], line.points[k + 1], width, strokes);
      else
        strokes.add(pixel(line.points[k]), pixel(line.points[k + 1]), width);
    }
    strokes.draw(from_srgb(line.color), picture_);
  }

  void paint(const DrawnText& text) {
    const int height = text.height * scale_;
    const Eigen::Vector2i place = pixel(text.place).array().round().matrix().cast<int>();
    const int width = painter_.width(text.text, height);
    const int before = text.anchor == TextAnchor::start    ? 0
                       : text.anchor == TextAnchor::middle ? width / 2
                                                           : width;
    painter_.draw(text.text, place.x() - before, place.y(), height, from_srgb(text.color),
                  picture_);
  }

  [[nodiscard]] const Picture& picture() const { return picture_; }

 private:
  [[nodiscard]] Eigen::Vector2f pixel(const Eigen::Vector2f& place) const {
    return static_cast<float>(scale_) * place;
  }

  void add_dashes(const Eigen::Vector2f& begin, const Eigen::Vector2f& end, float width,
                  Strokes& strokes) const {
    const float length = (end - begin).norm();
    const int count = static_cast<int>(std::ceil(length / (2 * dash)));
    for (int k = 0; k < count; ++k) {
      const float from = 2 * dash * static_cast<float>(k);
      const float to = std::min(from + dash, length);
      strokes.add(pixel(begin + (end - begin) * (from / length)),
                  pixel(begin + (end - begin) * (to / length)), width);
    }
  }

  int scale_;
  Picture picture_;
  CaptionPainter painter_;
};

}  // namespace

Picture painted(const ChartDrawing& drawing, int scale) {
  DrawingPainter painter(drawing.size, scale);
  for (const auto& shape : drawing.shapes)
    std::visit([&painter](const auto& drawn) { painter.paint(drawn); }, shape);
  return painter.picture();
}

}  // namespace ribbon
