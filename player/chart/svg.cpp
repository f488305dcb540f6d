#include "player/chart/chart_drawing.h"
#include "text/characters.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// Characters that XML 1.0 cannot hold.
bool is_forbidden(char32_t character) {
  return (character < 0x20 && character != '\t' && character != '\n' && character != '\r') ||
         character == 0xFFFE || character == 0xFFFF;
}

std::string xml_text(std::string_view text) {
  std::string xml;
  while (!text.empty()) {
    const char32_t character = take_character(text);
    if (character == '&')
      xml += "&amp;";
    else if (character == '<')
      xml += "&lt;";
    else if (character == '>')
      xml += "&gt;";
    else
      append_character(xml, is_forbidden(character) ? 0xFFFD : character);
  }
  return xml;
}

std::string hex_color(std::uint32_t color) {
  return filled_in("#{:06x}", color);
}

std::string element(const DrawnBox& box) {
  const Eigen::Vector2f size = box.high - box.low;
  return filled_in(R"(<rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" fill="{}"/>)",
                   box.low.x(), box.low.y(), size.x(), size.y(), hex_color(box.color));
}

std::string element(const DrawnLine& line) {
  if (line.points.size() == 1)
    return filled_in(R"(<circle cx="{:.2f}" cy="{:.2f}" r="{:.2f}" fill="{}"/>)",
                     line.points[0].x(), line.points[0].y(), line.width, hex_color(line.color));
  std::string corners;
  for (const Eigen::Vector2f& point : line.points)
    corners += (corners.empty() ? "" : " ") + filled_in("{:.2f},{:.2f}", point.x(), point.y());
  return filled_in(R"(<polyline points="{}" fill="none" stroke="{}" stroke-width="{:.2f}" )"
                   R"(stroke-linecap="round" stroke-linejoin="round"{}/>)",
                   corners, hex_color(line.color), line.width,
                   std::string(line.dashed ? R"( stroke-dasharray="4 4")" : ""));
}

std::string element(const DrawnText& text) {
  const char* anchor = text.anchor == TextAnchor::start    ? "start"
                       : text.anchor == TextAnchor::middle ? "middle"
                                                           : "end";
  return filled_in(
      R"(<text x="{:.2f}" y="{:.2f}" font-size="{}" text-anchor="{}" fill="{}">{}</text>)",
      text.place.x(), text.place.y(), text.height, std::string(anchor), hex_color(text.color),
      xml_text(text.text));
}

}  // namespace

std::string svg_text(const ChartDrawing& drawing) {
  std::string svg = filled_in(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" viewBox="0 0 {} {}" )"
      R"(font-family="DejaVu Sans, Verdana, sans-serif">)",
      drawing.size.width, drawing.size.height, drawing.size.width, drawing.size.height);
  svg += "\n<title>" + xml_text(drawing.title) + "</title>\n";
  for (const auto& shape : drawing.shapes)
    svg += std::visit([](const auto& drawn) { return element(drawn); }, shape) + "\n";
  return svg + "</svg>\n";
}

}  // namespace ribbon
