#include "player/chart/chart_page.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "player/chart/axis.h"
#include "player/chart/thinned.h"
#include "player/picture/caption.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

using Eigen::Vector2f;

// Lengths in pixels, colours as 0xRRGGBB.
struct Look {
  static constexpr std::uint32_t ink = 0x222222;
  static constexpr std::uint32_t pale_ink = 0x666666;
  static constexpr std::uint32_t grid_color = 0xE3E3E3;
  static constexpr std::uint32_t line_color = 0x2C6FAE;
  static constexpr std::uint32_t border_color = 0xC24D2C;
  static constexpr std::uint32_t zone_color = 0xE3F0E1;
  static constexpr std::uint32_t zone_ink = 0x4E8A47;

  static constexpr int text_height = 12;
  static constexpr int title_height = 18;
  static constexpr float margin = 24;
  static constexpr float heading = 74;  // above the first panel
  static constexpr float plot_width = 340;
  static constexpr float plot_height = 104;
  static constexpr float left_of_plot = 44;   // for the ticks' numbers
  static constexpr float right_of_plot = 52;  // for the last value
  static constexpr float above_plot = 26;     // for the panel's title
  static constexpr float below_plot = 12;
  static constexpr float below_page = 36;  // for the time axis
  static constexpr float panel_width = left_of_plot + plot_width + right_of_plot;
  static constexpr float panel_height = above_plot + plot_height + below_plot;
  static constexpr std::size_t most_in_a_column = 4;
};

struct Span {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Span times(const std::vector<Chart>& charts) {
  Span span;
  for (const Chart& chart : charts)
    for (const auto& line : chart.lines)
      for (const auto& point : line) span.include(point.x());
  return span.low <= span.high ? span : Span{0, 1};
}

// Zero is always there.
Span values(const Chart& chart) {
  Span span{0, 0};
  for (const auto& line : chart.lines)
    for (const auto& point : line) span.include(point.y());
  if (chart.zone) {
    span.include(chart.zone->low);
    span.include(chart.zone->high);
  }
  return span;
}

ChartAxis value_axis(const Chart& chart, float begin, float end) {
  Span span = values(chart);
  if (!(span.low < span.high)) return {0, 1, begin, end, 2};
  const bool is_left = span.high > chart.most_shown;
  span.high = std::min(span.high, chart.most_shown);
  // Lines do not run along the plot's border, but for zero.
  const double free = (span.high - span.low) / 20;
  const double most = chart.counts ? std::clamp(span.high + 1, 2.0, 6.0) : 6;
  return {span.low < 0 ? span.low - free : 0,
          span.high > 0 && !is_left ? span.high + free : span.high, begin, end,
          static_cast<int>(most)};
}

using Points = std::vector<Eigen::Vector2d>;

// The parts of a line that are no higher, with the places where it passes that height.
std::vector<Points> parts_up_to(double height, const Points& line) {
  std::vector<Points> parts;
  bool was_shown = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const bool is_shown = line[k].y() <= height;
    if (is_shown && !was_shown) parts.emplace_back();
    if (k > 0 && is_shown != was_shown) {
      const double share = (height - line[k - 1].y()) / (line[k].y() - line[k - 1].y());
      parts.back().emplace_back(std::lerp(line[k - 1].x(), line[k].x(), share), height);
    }
    if (is_shown) parts.back().push_back(line[k]);
    was_shown = is_shown;
  }
  return parts;
}

class PagePainter {
 public:
  PagePainter(ChartDrawing& page, const Span& time) : page_(page), time_(time) {}

  // With the upper left corner of the plot there.
  void add(const Chart& chart, const Vector2f& corner, bool names_time) {
    const ChartAxis x(time_.low, time_.high, corner.x(), corner.x() + Look::plot_width, 8);
    const ChartAxis y = value_axis(chart, corner.y() + Look::plot_height, corner.y());
    text({corner.x(), corner.y() - 9}, chart.title, TextAnchor::start, Look::ink);
    if (chart.zone) add_zone(*chart.zone, y, corner);
    add_axes(x, y, corner, names_time);
    if (chart.zone) add_zone_name(*chart.zone, y, corner);
    for (const Points& points : chart.lines)
      for (const Points& part : parts_up_to(chart.most_shown, points)) add_line(part, x, y);
    if (!chart.lines.empty()) add_last_value(chart.lines.back().back(), x, y, chart.most_shown);
  }

 private:
  void text(const Vector2f& place, const std::string& words, TextAnchor anchor,
            std::uint32_t color) {
    page_.shapes.emplace_back(DrawnText{place, words, Look::text_height, anchor, color});
  }
  void line(const Vector2f& begin, const Vector2f& end, std::uint32_t color) {
    page_.shapes.emplace_back(DrawnLine{{begin, end}, color, 1, false});
  }

  void add_axes(const ChartAxis& x, const ChartAxis& y, const Vector2f& corner, bool names_time) {
    const float right = corner.x() + Look::plot_width;
    const float bottom = corner.y() + Look::plot_height;
    for (const double value : y.ticks().values) {
      const float place = y.place(value);
      line({corner.x(), place}, {right, place}, Look::grid_color);
      text({corner.x() - 7, place + 4}, y.ticks().text(value), TextAnchor::end, Look::pale_ink);
    }
    line({corner.x(), y.place(0)}, {right, y.place(0)}, Look::pale_ink);
    for (const double value : x.ticks().values) {
      const float place = x.place(value);
      line({place, bottom}, {place, bottom + 4}, Look::pale_ink);
      if (names_time)
        text({place, bottom + 17}, x.ticks().text(value), TextAnchor::middle, Look::pale_ink);
    }
    if (names_time)
      text({corner.x() + Look::plot_width / 2, bottom + 36}, "time, s", TextAnchor::middle,
           Look::ink);
  }

  void add_zone(const ChartZone& zone, const ChartAxis& y, const Vector2f& corner) {
    if (zone.low < zone.high)
      page_.shapes.emplace_back(DrawnBox{{corner.x(), y.place(zone.high)},
                                         {corner.x() + Look::plot_width, y.place(zone.low)},
                                         Look::zone_color});
  }

  // Over the grid; of a border, with its line.
  void add_zone_name(const ChartZone& zone, const ChartAxis& y, const Vector2f& corner) {
    const float right = corner.x() + Look::plot_width;
    const bool is_border = zone.low == zone.high;
    if (is_border)
      page_.shapes.emplace_back(
          DrawnLine{{{corner.x(), y.place(zone.low)}, {right, y.place(zone.low)}},
                    Look::border_color,
                    1.2F,
                    true});
    text({corner.x() + 6, y.place(zone.high) + (is_border ? 15.0F : -4.0F)}, zone.name,
         TextAnchor::start, is_border ? Look::border_color : Look::zone_ink);
  }

  void add_line(const Points& points, const ChartAxis& x, const ChartAxis& y) {
    DrawnLine drawn{{}, Look::line_color, 1.6F, false};
    for (const Eigen::Vector2d& point : points)
      drawn.points.emplace_back(x.place(point.x()), y.place(point.y()));
    drawn.points = thinned(drawn.points);
    page_.shapes.emplace_back(std::move(drawn));
  }

  // Where the line has left the plot, at its border.
  void add_last_value(const Eigen::Vector2d& last, const ChartAxis& x, const ChartAxis& y,
                      double most_shown) {
    const Vector2f place(x.place(last.x()), y.place(std::min(last.y(), most_shown)));
    page_.shapes.emplace_back(DrawnLine{{place}, Look::line_color, 2.5F, false});
    text({place.x() + 8, place.y() + 4}, short_number(last.y(), 3), TextAnchor::start,
         Look::line_color);
  }

  ChartDrawing& page_;
  Span time_;
};

// Of the panels side by side; two of them where the subtitle would not find room above one.
int page_width(std::size_t columns, int subtitle_width) {
  const auto width_of = [](std::size_t panels) {
    return static_cast<int>(2 * Look::margin + static_cast<float>(panels) * Look::panel_width);
  };
  const int wanted = subtitle_width + static_cast<int>(2 * Look::margin);
  return std::max(width_of(columns), std::min(width_of(2), wanted));
}

}  // namespace

ChartDrawing chart_page(const std::string& title, const std::string& subtitle,
                        const std::vector<Chart>& charts) {
  assert(!charts.empty());
  const std::size_t rows = std::min(charts.size(), Look::most_in_a_column);
  const std::size_t columns = (charts.size() + rows - 1) / rows;
  ChartDrawing page;
  page.title = title;
  const CaptionPainter letters;
  page.size = {page_width(columns, letters.width(subtitle, Look::text_height)),
               static_cast<int>(Look::heading + static_cast<float>(rows) * Look::panel_height +
                                Look::below_page)};
  page.shapes.emplace_back(
      DrawnBox{Vector2f::Zero(),
               {static_cast<float>(page.size.width), static_cast<float>(page.size.height)},
               0xFFFFFF});
  const auto heading = [&](const std::string& text, float baseline, int height,
                           std::uint32_t color) {
    const int room = page.size.width - static_cast<int>(2 * Look::margin);
    page.shapes.emplace_back(DrawnText{{Look::margin, baseline},
                                       letters.fitted(text, height, room),
                                       height,
                                       TextAnchor::start,
                                       color});
  };
  heading(title, 34, Look::title_height, Look::ink);
  heading(subtitle, 55, Look::text_height, Look::pale_ink);
  PagePainter painter(page, times(charts));
  for (std::size_t k = 0; k < charts.size(); ++k) {
    const std::size_t before = k / rows;  // columns
    const std::size_t above = k % rows;
    const auto column = static_cast<float>(before);
    const auto row = static_cast<float>(above);
    const bool is_lowest = above == rows - 1 || k + 1 == charts.size();
    painter.add(charts[k],
                {Look::margin + column * Look::panel_width + Look::left_of_plot,
                 Look::heading + row * Look::panel_height + Look::above_plot},
                is_lowest);
  }
  return page;
}

}  // namespace ribbon
