#include "curve/diagram_svg.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <limits>

#include "geometry/lengths_along.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;

// All in the drawing's diagonal.
constexpr double widest_half_gap = 0.01;
constexpr double stroke = 0.003;
constexpr double dash = 0.008;
constexpr double largest_letter = 0.022;
constexpr double page_margin = 0.05;

// All in the room that a passage has: the shorter way to the passages before and behind.
constexpr double half_gap_per_room = 1.0 / 3;
constexpr double letter_per_room = 0.4;

constexpr int digits = 9;  // enough to read the same knot again

// The drawing measured by its length.
class MeasuredDrawing {
 public:
  explicit MeasuredDrawing(const Drawing& points)
      : points_(points), length_at_(lengths_along(points)) {}

  [[nodiscard]] double length() const { return length_at_.back(); }
  [[nodiscard]] double length_at(double parameter) const {
    const std::size_t i = std::min(static_cast<std::size_t>(parameter), points_.size() - 2);
    return length_at_[i] +
           (parameter - static_cast<double>(i)) * (length_at_[i + 1] - length_at_[i]);
  }
  [[nodiscard]] Vector2d point_at(double length) const {
    const std::size_t i = segment_at(length);
    const double fraction = (length - length_at_[i]) / (length_at_[i + 1] - length_at_[i]);
    return points_[i] + fraction * (points_[i + 1] - points_[i]);
  }
  [[nodiscard]] Vector2d direction_at(double length) const {
    const std::size_t i = segment_at(length);
    return (points_[i + 1] - points_[i]) / (length_at_[i + 1] - length_at_[i]);
  }
  [[nodiscard]] Drawing piece(double begin, double end) const {
    Drawing piece{point_at(begin)};
    for (std::size_t i = segment_at(begin) + 1; i < points_.size() && length_at_[i] < end; ++i)
      if (length_at_[i] > begin) piece.push_back(points_[i]);
    piece.push_back(point_at(end));
    return piece;
  }

 private:
  [[nodiscard]] std::size_t segment_at(double length) const {
    const auto after = std::upper_bound(length_at_.begin() + 1, length_at_.end() - 1, length);
    return static_cast<std::size_t>(after - length_at_.begin()) - 1;
  }

  const Drawing& points_;
  std::vector<double> length_at_;
};

std::string number(double value) {
  return short_number(value, digits);
}

std::string path_of(const Drawing& piece, const std::string& attributes) {
  std::string path = "    <path" + attributes + " d=\"M";
  for (const Vector2d& point : piece) {
    path += ' ';
    path += number(point.x());
    path += ' ';
    path += number(point.y());
  }
  return path + "\"/>\n";
}

// A passage as it is drawn, by length.
struct DrawnPassage {
  double length;
  double half_gap;  // 0 where none is needed
  double letter;    // size of its number
};

// The passages of crossings and of the object, as they are counted.
std::vector<DrawnPassage> drawn_passages(const MeasuredDrawing& drawing,
                                         const std::vector<Passage>& passages,
                                         const std::vector<ObjectPassage>& objects,
                                         double diagonal) {
  const auto all = counted(passages, objects);
  std::vector<double> lengths;
  lengths.reserve(all.size());
  for (const CountedPassage& passage : all) lengths.push_back(drawing.length_at(passage.parameter));
  constexpr double free = std::numeric_limits<double>::infinity();
  std::vector<DrawnPassage> drawn;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double before = i == 0 ? free : lengths[i] - lengths[i - 1];
    const double after = i + 1 == lengths.size() ? free : lengths[i + 1] - lengths[i];
    const double room_of_letter = std::min(before, after);  // which may stand beyond the ends
    const double room = std::min({room_of_letter, lengths[i], drawing.length() - lengths[i]});
    const bool is_under = !all[i].of_object && !passages[all[i].index].over;
    drawn.push_back(
        {lengths[i],
         is_under ? std::min(half_gap_per_room * room, widest_half_gap * diagonal) : 0.0,
         std::min(letter_per_room * room_of_letter, largest_letter * diagonal)});
  }
  return drawn;
}

// A stretch of the drawing that is one stroke, by length.
struct Stroke {
  double begin;
  double end;
  std::string attributes = {};
};

// Where the drawing passes the object.
std::vector<Stroke> object_strokes(const MeasuredDrawing& drawing,
                                   const std::vector<ObjectPassage>& objects, double diagonal) {
  const std::string dashes =
      R"( class="behind" stroke-dasharray=")" + number(dash * diagonal) + "\"";
  std::vector<Stroke> strokes;
  strokes.reserve(objects.size());
  for (const auto& [run, in_front] : objects)
    strokes.push_back({drawing.length_at(run.begin), drawing.length_at(run.end),
                       in_front ? " class=\"front\"" : dashes});
  return strokes;
}

// Between gaps, cut where strokes of the object begin and end.
std::string pieces_of(const MeasuredDrawing& drawing, const std::vector<DrawnPassage>& passages,
                      const std::vector<Stroke>& objects) {
  std::string paths;
  double begin = 0;
  const auto draw_to = [&](double end, const std::string& attributes) {
    if (end > begin) paths += path_of(drawing.piece(begin, end), attributes);
    begin = std::max(begin, end);
  };
  auto object = objects.begin();
  const auto draw_pieces_to = [&](double end) {
    for (; object != objects.end() && object->begin < end; ++object) {
      draw_to(object->begin, "");
      draw_to(std::min(object->end, end), object->attributes);
      if (object->end > end) return;
    }
    draw_to(end, "");
  };
  for (const DrawnPassage& passage : passages) {
    if (passage.half_gap == 0) continue;
    draw_pieces_to(passage.length - passage.half_gap);
    begin = passage.length + passage.half_gap;
  }
  draw_pieces_to(drawing.length());
  return paths;
}

// Before the crossing, on the left of the strand.
std::string label(const MeasuredDrawing& drawing, const DrawnPassage& passage,
                  const std::string& text) {
  const double size = passage.letter;
  const double length = passage.length - 0.8 * size;
  const Vector2d along = drawing.direction_at(length);
  const Vector2d aside = 0.7 * size * Vector2d(along.y(), -along.x());
  const Vector2d at = drawing.point_at(length) + aside + Vector2d(0, 0.35 * size);
  return "    <text x=\"" + number(at.x()) + "\" y=\"" + number(at.y()) + "\" font-size=\"" +
         number(size) + "\">" + text + "</text>\n";
}

std::string view_box(const Drawing& drawing, double room) {
  Eigen::AlignedBox2d box;
  for (const Vector2d& point : drawing) box.extend(point);
  const Vector2d corner = box.min() - Vector2d::Constant(room);
  const Vector2d size = box.sizes() + Vector2d::Constant(2 * room);
  return number(corner.x()) + " " + number(corner.y()) + " " + number(size.x()) + " " +
         number(size.y());
}

}  // namespace

std::string diagram_svg(const Drawing& drawing, const std::vector<Passage>& passages,
                        const std::vector<ObjectPassage>& objects) {
  const double diagonal = extent_of(drawing);
  const MeasuredDrawing measured(drawing);
  const std::vector<DrawnPassage> drawn = drawn_passages(measured, passages, objects, diagonal);
  const std::string pieces =
      pieces_of(measured, drawn, object_strokes(measured, objects, diagonal));
  std::string labels;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    labels += label(measured, drawn[i], std::to_string(i + 1));
  return R"(<svg xmlns="http://www.w3.org/2000/svg" width="1000" viewBox=")" +
         view_box(drawing, page_margin * diagonal) +
         "\">\n  <g id=\"band\" fill=\"none\" stroke=\"#8f1d3c\" stroke-width=\"" +
         number(stroke * diagonal) + "\">\n" + pieces +
         "  </g>\n  <g font-family=\"sans-serif\" text-anchor=\"middle\">\n" + labels +
         "  </g>\n</svg>\n";
}

}  // namespace ribbon
