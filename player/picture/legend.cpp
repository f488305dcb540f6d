#include "player/picture/legend.h"

#include <algorithm>

#include "player/picture/page_colors.h"

namespace ribbon {

namespace {

// Everything in terms of the letters' height.
struct LegendLayout {
  int text;
  int padding = (3 * text) / 4;
  int bar_left = 2 * padding;
  int bar_width = 18 * text;
  int bar_height = (7 * text) / 8;
  int gap = text / 2;
  int line = (5 * text) / 4;

  [[nodiscard]] int width() const { return bar_width + 5 * padding; }
  [[nodiscard]] int height() const { return 2 * padding + 2 * line + gap + bar_height; }
};

// One column of pixels of the bar.
Color bar_color(const Legend& legend, int column, int width) {
  if (!legend.fields)
    return legend.map.at((static_cast<float>(column) + 0.5F) / static_cast<float>(width));
  const auto fields = static_cast<int>(legend.marks.size());
  return legend.map.at(legend.marks[column * fields / width].place);
}

// Where mark k is told, from the bar's left end.
int mark_column(const Legend& legend, int k, int width) {
  if (legend.fields) return (2 * k + 1) * width / (2 * static_cast<int>(legend.marks.size()));
  return static_cast<int>(legend.marks[k].place * static_cast<float>(width));
}

// Where the text of mark k begins and ends, from the bar's left end; it stays on the legend.
struct Extent {
  int left;
  int right;
};

Extent extent(const Legend& legend, int k, const LegendLayout& layout,
              const CaptionPainter& painter) {
  const int width = painter.width(legend.marks[k].text, layout.text);
  const int first = layout.gap / 2 - layout.bar_left;
  const int last = layout.width() - layout.bar_left - layout.gap / 2 - width;
  const int left = std::clamp(mark_column(legend, k, layout.bar_width) - width / 2, first,
                              std::max(first, last));
  return {left, left + width};
}

// The marks that are told: those of both ends, and from the left on what keeps clear of them and of
// one another.
std::vector<int> marks_with_room(const Legend& legend, const LegendLayout& layout,
                                 const CaptionPainter& painter) {
  const auto count = static_cast<int>(legend.marks.size());
  std::vector<int> told;
  if (count == 0) return told;
  const int end = extent(legend, count - 1, layout, painter).left - layout.gap;
  for (int k = 0; k < count - 1; ++k) {
    const auto [left, right] = extent(legend, k, layout, painter);
    const bool is_clear =
        told.empty() || left >= extent(legend, told.back(), layout, painter).right + layout.gap;
    if (k == 0 || (is_clear && right <= end)) told.push_back(k);
  }
  told.push_back(count - 1);
  return told;
}

void draw_marks(const Legend& legend, const LegendLayout& layout, int left, int bottom,
                const CaptionPainter& painter, Picture& picture) {
  for (const int k : marks_with_room(legend, layout, painter)) {
    const int x = left + mark_column(legend, k, layout.bar_width);
    if (!legend.fields) {
      const int tick_x = std::clamp(x, left, left + layout.bar_width - 1);
      fill({tick_x, bottom, tick_x + 1, bottom + layout.gap / 2}, page_ink, 1, picture);
    }
    painter.draw(legend.marks[k].text, left + extent(legend, k, layout, painter).left,
                 bottom + layout.gap / 2 + layout.text, layout.text, page_ink, picture);
  }
}

}  // namespace

int picture_text_height(PictureSize size) {
  return std::max(9, std::min(size.height / 45, size.width / 48));
}

PictureSize legend_size(int text_height) {
  const LegendLayout layout{text_height};
  return {layout.width(), layout.height()};
}

void draw_legend(const Legend& legend, int left, int top, int text_height,
                 const CaptionPainter& painter, Picture& picture) {
  const LegendLayout layout{text_height};
  const int bar_left = left + layout.bar_left;
  const int title_baseline = top + layout.padding + layout.text;
  painter.draw(legend.title, bar_left, title_baseline, layout.text, page_ink, picture);
  const int bar_top = title_baseline + layout.gap;
  for (int column = 0; column < layout.bar_width; ++column)
    fill({bar_left + column, bar_top, bar_left + column + 1, bar_top + layout.bar_height},
         bar_color(legend, column, layout.bar_width), 1, picture);
  draw_marks(legend, layout, bar_left, bar_top + layout.bar_height, painter, picture);
}

void draw_corner_legend(const Legend& legend, const CaptionPainter& painter, Picture& picture) {
  const int text = picture_text_height(picture.size);
  const PictureSize size = legend_size(text);
  const int top = picture.size.height - text - size.height;
  fill({text, top, text + size.width, top + size.height}, page_paper, 0.75F, picture);
  draw_legend(legend, text, top, text, painter, picture);
}

}  // namespace ribbon
