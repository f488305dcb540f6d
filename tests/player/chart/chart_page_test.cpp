#include "player/chart/chart_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <sstream>

#include "player/chart/thinned.h"
#include "player/picture/caption.h"

namespace ribbon::chart_page_test {

using testing::Contains;
using testing::ElementsAre;
using testing::IsSupersetOf;
using testing::Not;
using testing::SizeIs;

Chart chart_of(std::vector<std::vector<Eigen::Vector2d>> lines) {
  Chart chart;
  chart.title = "height, m";
  chart.lines = std::move(lines);
  return chart;
}

// An SVG as a browser reads it.
class SvgPage {
 public:
  explicit SvgPage(const ChartDrawing& drawing) {
    const std::string svg = svg_text(drawing);
    const auto read = page_.load_buffer(svg.data(), svg.size());
    EXPECT_TRUE(read) << read.description() << "\n" << svg;
  }

  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> result;
    for (const pugi::xml_node& node : page_.child("svg").children("text"))
      result.emplace_back(node.child_value());
    return result;
  }

  // The corners of each line of that colour.
  [[nodiscard]] std::vector<std::vector<Eigen::Vector2f>> lines(const std::string& color) const {
    std::vector<std::vector<Eigen::Vector2f>> result;
    for (const pugi::xml_node& node : page_.child("svg").children("polyline"))
      if (node.attribute("stroke").value() == color)
        result.push_back(points(node.attribute("points").value()));
    return result;
  }

  [[nodiscard]] std::string title() const { return page_.child("svg").child_value("title"); }

 private:
  static std::vector<Eigen::Vector2f> points(const std::string& text) {
    std::vector<Eigen::Vector2f> result;
    std::istringstream stream(text);
    char comma = 0;
    for (Eigen::Vector2f point; stream >> point.x() >> comma >> point.y();) result.push_back(point);
    return result;
  }

  pugi::xml_document page_;
};

const std::string data_color = "#2c6fae";

TEST(ChartPage, points_stand_where_their_values_are) {
  const SvgPage page(chart_page("title", "subtitle", {chart_of({{{0, 0}, {1, 25}, {4, 100}}})}));
  const auto lines = page.lines(data_color);
  ASSERT_THAT(lines, ElementsAre(SizeIs(3)));
  const Eigen::Vector2f whole = lines[0][2] - lines[0][0];
  EXPECT_GT(whole.x(), 300);
  EXPECT_LT(whole.y(), -90);  // upwards
  EXPECT_TRUE((lines[0][1] - lines[0][0]).isApprox(whole / 4, 0.01F));
  EXPECT_THAT(page.texts(),
              IsSupersetOf({"title", "subtitle", "height, m", "0", "20", "100", "time, s"}));
}

TEST(ChartPage, a_broken_line_is_drawn_in_its_parts_and_a_single_point_as_a_dot) {
  const ChartDrawing drawing =
      chart_page("", "", {chart_of({{{0, 1}, {1, 2}}, {{3, 3}}, {{5, 1}, {6, 2}, {7, 2}}})});
  EXPECT_THAT(SvgPage(drawing).lines(data_color), ElementsAre(SizeIs(2), SizeIs(3)));
  EXPECT_THAT(svg_text(drawing), testing::HasSubstr("<circle"));
}

TEST(ChartPage, a_line_leaves_the_plot_above_the_most_that_is_shown) {
  Chart chart = chart_of({{{0, 500}, {1, 100}, {2, 0}, {3, 200}, {4, 900}}});
  chart.most_shown = 150;
  const SvgPage page(chart_page("", "", {chart}));
  const auto lines = page.lines(data_color);
  ASSERT_THAT(lines, ElementsAre(SizeIs(4)));
  const float top = lines[0].front().y();
  EXPECT_EQ(lines[0].back().y(), top);
  EXPECT_NEAR(lines[0][2].y() - lines[0][1].y(), 2 * (lines[0][1].y() - top), 0.1);
  EXPECT_GT(lines[0].back().x(), lines[0][2].x());
  EXPECT_THAT(page.texts(), IsSupersetOf({"100", "900"}));
  EXPECT_THAT(page.texts(), Not(Contains("500")));
}

TEST(ChartPage, counts_have_whole_ticks) {
  Chart chart = chart_of({{{0, 0}, {1, 2}}});
  chart.counts = true;
  EXPECT_THAT(SvgPage(chart_page("", "", {chart})).texts(), IsSupersetOf({"0", "1", "2"}));
  EXPECT_THAT(SvgPage(chart_page("", "", {chart})).texts(), Not(Contains("0.5")));
}

TEST(ChartPage, any_name_makes_a_page_that_can_be_read) {
  const std::string name = "a<b>&\"'\x01\xff\xed\xa0\x80 \xe2\x89\xa5";
  const SvgPage page(chart_page(name, "", {chart_of({{{0, 1}}})}));
  const std::string broken = "\xef\xbf\xbd";
  EXPECT_EQ(page.title(), "a<b>&\"'" + broken + broken + broken + " \xe2\x89\xa5");
}

TEST(ChartPage, any_numbers_make_a_page_whose_places_are_finite) {
  const double huge = 1e300;
  const double tiny = 5e-324;
  for (const auto& lines :
       std::vector<std::vector<std::vector<Eigen::Vector2d>>>{{},
                                                              {{{0, 0}}},
                                                              {{{3, huge}, {3, -huge}}},
                                                              {{{-huge, tiny}, {huge, 2 * tiny}}},
                                                              {{{5, 7}, {2, 1}}},
                                                              {{{1e15, 1}, {1e15 + 1, 1}}}}) {
    const ChartDrawing drawing = chart_page("", "", {chart_of(lines)});
    for (const auto& line : SvgPage(drawing).lines(data_color))
      for (const Eigen::Vector2f& point : line) EXPECT_TRUE(point.allFinite());
    EXPECT_THAT(svg_text(drawing), Not(testing::HasSubstr("nan")));
    EXPECT_THAT(svg_text(drawing), Not(testing::HasSubstr("inf")));
  }
}

TEST(ChartPage, eight_charts_stand_in_two_columns_and_three_in_one) {
  const Chart chart = chart_of({{{0, 0}, {1, 1}}});
  const ChartDrawing three = chart_page("", "", std::vector<Chart>(3, chart));
  const ChartDrawing eight = chart_page("", "", std::vector<Chart>(8, chart));
  EXPECT_GT(eight.size.width, 1.8 * three.size.width);
  EXPECT_GT(eight.size.height, three.size.height);
}

TEST(ChartPage, long_headings_find_room) {
  const CaptionPainter letters;
  const std::string title(300, 'm');
  const Chart chart = chart_of({{{0, 0}, {1, 1}}});
  for (const int words : {1, 15, 90}) {
    std::string subtitle;
    for (int word = 0; word < words; ++word) subtitle += "particles ";
    const ChartDrawing page = chart_page(title, subtitle, {chart});
    int headings = 0;
    for (const auto& shape : page.shapes)
      if (const auto* text = std::get_if<DrawnText>(&shape);
          text != nullptr && text->anchor == TextAnchor::start && text->place.x() < 30) {
        EXPECT_LE(text->place.x() + static_cast<float>(letters.width(text->text, text->height)),
                  static_cast<float>(page.size.width));
        ++headings;
      }
    EXPECT_GE(headings, 2);
    const SvgPage svg(page);
    EXPECT_EQ(std::ranges::count(svg.texts(), subtitle), words <= 15 ? 1 : 0);
  }
}

TEST(ChartPage, pixels_have_the_line_where_the_svg_has_it) {
  const ChartDrawing drawing =
      chart_page("title", "subtitle", {chart_of({{{0, 0}, {1, 25}, {2, 100}, {4, 50}}})});
  const Picture picture = painted(drawing, 2);
  EXPECT_EQ(picture.size, (PictureSize{2 * drawing.size.width, 2 * drawing.size.height}));
  const auto corners = SvgPage(drawing).lines(data_color).at(0);
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const Eigen::Vector2f middle = corners[k] + corners[k + 1];  // twice: in pixels
    const std::uint8_t* rgb =
        picture.pixel(static_cast<int>(middle.x()), static_cast<int>(middle.y()));
    EXPECT_THAT(std::vector<int>(rgb, rgb + 3), ElementsAre(0x2C, 0x6F, 0xAE)) << k;
  }
  EXPECT_EQ(painted(drawing, 2).rgb, picture.rgb);
}

TEST(ThinnedLine, keeps_short_lines_as_they_are) {
  const std::vector<Eigen::Vector2f> line = {{0, 3}, {1, 5}, {2.5F, 1}, {9, 0}};
  EXPECT_EQ(thinned(line), line);
  EXPECT_THAT(thinned({}), SizeIs(0));
}

TEST(ThinnedLine, keeps_the_ends_and_the_extremes_of_long_ones) {
  std::vector<Eigen::Vector2f> line;
  line.reserve(50'000);
  for (int k = 0; k < 50'000; ++k)
    line.emplace_back(0.006F * static_cast<float>(k), std::sin(0.7F * static_cast<float>(k)));
  line[12'345].y() = 9;
  line[23'456].y() = -9;
  const auto kept = thinned(line);
  EXPECT_LE(kept.size(), 4U * 601);
  EXPECT_THAT(kept, IsSupersetOf({line.front(), line[12'345], line[23'456], line.back()}));
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end(),
                             [](const auto& a, const auto& b) { return a.x() < b.x(); }));
}

}  // namespace ribbon::chart_page_test
