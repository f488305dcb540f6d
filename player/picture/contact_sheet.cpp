#include "player/picture/contact_sheet.h"

#include <cassert>

#include "player/picture/caption.h"
#include "player/picture/page_colors.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr int sheet_margin = 24;
constexpr int cell_gap = 8;
constexpr int title_height = 26;
constexpr int text_height = 15;
constexpr int line_height = 21;
constexpr int heading_height = sheet_margin + title_height + line_height + 20;
constexpr int caption_height = 2 * line_height + sheet_margin;

PictureSize sheet_size(int columns, int views) {
  return {2 * sheet_margin + columns * sheet_cell.width + (columns - 1) * cell_gap,
          heading_height + views * (sheet_cell.height + cell_gap) + caption_height};
}

// Down to two thirds as high where the room asks for it, and then shortened.
void draw_line(const std::string& line, int left, int baseline, int height, int room,
               const Color& ink, const CaptionPainter& painter, Picture& sheet) {
  const int smallest = 2 * height / 3;
  while (height > smallest && painter.width(line, height) > room) --height;
  painter.draw(painter.fitted(line, height, room), left, baseline, height, ink, sheet);
}

void draw_column(const SheetColumn& column, int left, const CaptionPainter& painter,
                 Picture& sheet) {
  int top = heading_height;
  for (const Picture& view : column.views) {
    paste(view, left, top, sheet);
    top += sheet_cell.height + cell_gap;
  }
  for (const std::string& line : sheet_caption(column.frame_number, column.numbers, column.stage)) {
    draw_line(line, left, top + text_height, text_height, sheet_cell.width, page_ink, painter,
              sheet);
    top += line_height;
  }
}

}  // namespace

std::vector<std::string> sheet_caption(int frame_number, const FrameNumbers& numbers,
                                       const std::string& stage) {
  const std::uint32_t edges = numbers.penetrating_edges;
  return {filled_in("frame {} · {:.2f} s", frame_number, numbers.time_s) +
              (stage.empty() ? "" : " · " + stage),
          filled_in("strain {:.1f} % · {} {}", 100 * numbers.worst_strain, edges,
                    edges == 1 ? "penetration" : "penetrations")};
}

Picture contact_sheet(const std::string& title, const std::string& subtitle,
                      const std::vector<SheetColumn>& columns,
                      const std::optional<Legend>& legend) {
  assert(!columns.empty());
  const CaptionPainter painter;
  Picture sheet = blank_picture(
      sheet_size(static_cast<int>(columns.size()), static_cast<int>(columns[0].views.size())),
      page_paper);
  int room = sheet.size.width - 2 * sheet_margin;
  if (legend) {
    const PictureSize size = legend_size(text_height);
    room -= size.width;
    draw_legend(*legend, sheet_margin + room, (heading_height - size.height) / 2, text_height,
                painter, sheet);
  }
  draw_line(title, sheet_margin, sheet_margin + title_height - 6, title_height, room, page_ink,
            painter, sheet);
  draw_line(subtitle, sheet_margin, sheet_margin + title_height + line_height - 4, text_height,
            room, page_pale_ink, painter, sheet);
  int left = sheet_margin;
  for (const SheetColumn& column : columns) {
    draw_column(column, left, painter, sheet);
    left += sheet_cell.width + cell_gap;
  }
  return sheet;
}

std::vector<int> spread_frames(const std::vector<int>& frames, int most) {
  assert(most >= 2);
  const auto count = static_cast<int>(frames.size());
  if (count <= most) return frames;
  std::vector<int> chosen(most);
  for (int i = 0; i < most; ++i)
    chosen[i] = frames[static_cast<std::size_t>(i) * (count - 1) / (most - 1)];
  return chosen;
}

}  // namespace ribbon
