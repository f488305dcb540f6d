#include "curve/path_data.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <svgpp/parser/path_data.hpp>
#include <svgpp/parser/transform_list.hpp>
#include <utility>

#include "geometry/angles.h"
#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;

// A malformed attribute is an answer here, not an exception.
struct AnswerFalse {
  using context_type = void;
  template <class Context, class Attribute, class Text>
  static bool parse_failed(Context& /*context*/, Attribute /*attribute*/, const Text& /*text*/) {
    return false;
  }
};

// At least four chords even to a coarse tolerance, so that no curve, not even one that ends where
// it starts, collapses to a point.
int chord_count(double wanted) {
  return static_cast<int>(std::ceil(std::clamp(wanted, 4.0, 1e4)));
}

// Of any number of turns.
double radians(double degrees) {
  return std::fmod(degrees, 360) * std::numbers::pi / 180;
}

// Receives the path's events, all absolute and without shorthands, and collects chords.
class Flattener {
 public:
  Flattener(Eigen::Affine2d root_from_path, double tolerance)
      : root_from_path_(std::move(root_from_path)), tolerance_(tolerance) {}

  template <class Absolute>
  void path_move_to(double x, double y, Absolute /*tag*/) {
    current_ = {x, y};
    subpath_is_empty_ = true;
  }

  template <class Absolute>
  void path_line_to(double x, double y, Absolute /*tag*/) {
    begin_segment();
    end_segment({x, y});
  }

  template <class Absolute>
  void path_quadratic_bezier_to(double x1, double y1, double x, double y, Absolute tag) {
    const Vector2d middle(x1, y1);
    const Vector2d end(x, y);
    const Vector2d c1 = current_ + (middle - current_) * (2.0 / 3.0);
    const Vector2d c2 = end + (middle - end) * (2.0 / 3.0);
    path_cubic_bezier_to(c1.x(), c1.y(), c2.x(), c2.y(), x, y, tag);
  }

  // A cubic stays within 6/8 of its largest second difference / n^2 of n even chords.
  template <class Absolute>
  void path_cubic_bezier_to(double x1, double y1, double x2, double y2, double x, double y,
                            Absolute /*tag*/) {
    begin_segment();
    const Vector2d p0 = in_root(current_);
    const Vector2d p1 = in_root(Vector2d(x1, y1));
    const Vector2d p2 = in_root(Vector2d(x2, y2));
    const Vector2d p3 = in_root(Vector2d(x, y));
    const double bend = std::max(length_of(p0 - 2 * p1 + p2), length_of(p1 - 2 * p2 + p3));
    add_chords(std::sqrt(0.75 * bend / tolerance_), [&](double t) -> Vector2d {
      const double u = 1 - t;
      return u * u * u * p0 + 3 * u * u * t * p1 + 3 * u * t * t * p2 + t * t * t * p3;
    });
    end_segment({x, y});
  }

  template <class Absolute>
  void path_elliptical_arc_to(double rx, double ry, double rotation_deg, bool large, bool sweep,
                              double x, double y, Absolute /*tag*/) {
    begin_segment();
    if (rx > 0 && ry > 0 && current_ != Vector2d(x, y))
      add_arc({rx, ry}, radians(rotation_deg), large, sweep, {x, y});
    end_segment({x, y});
  }

  void path_close_subpath() { path_.closed = true; }
  void path_exit() {}

  [[nodiscard]] const FlatPath& path() const { return path_; }

 private:
  void begin_segment() {
    if (!subpath_is_empty_) return;
    subpath_is_empty_ = false;
    path_.pieces.emplace_back();
    add(in_root(current_));
  }

  void end_segment(const Vector2d& end) {
    current_ = end;
    add(in_root(end));
  }

  // Written out: Eigen's order depends on vector instructions.
  [[nodiscard]] Vector2d turned(const Vector2d& direction) const {
    const auto& m = root_from_path_.linear();
    return {m(0, 0) * direction.x() + m(0, 1) * direction.y(),
            m(1, 0) * direction.x() + m(1, 1) * direction.y()};
  }
  [[nodiscard]] Vector2d in_root(const Vector2d& point) const {
    return turned(point) + root_from_path_.translation();
  }

  void add(const Vector2d& point) {
    std::vector<Vector2d>& piece = path_.pieces.back();
    if (piece.empty() || piece.back() != point) piece.push_back(point);
  }

  // The points between the ends of the curve `point`(0 ... 1).
  void add_chords(double wanted, const std::function<Vector2d(double)>& point) {
    const int n = chord_count(wanted);
    for (int i = 1; i < n; ++i) add(point(static_cast<double>(i) / n));
  }

  // From the ends of an arc to its centre: "Elliptical arc implementation notes" of SVG 1.1, F.6.5.
  // In the frame of the ellipse, from the middle of the chord, the arc begins at `begin`.
  void add_arc(Vector2d radii, double rotation, bool large, bool sweep, const Vector2d& end) {
    const Vector2d first_axis(cosine(rotation), sine(rotation));
    const Vector2d second_axis(-first_axis.y(), first_axis.x());
    const Vector2d half_chord = (current_ - end) / 2;
    const Vector2d begin(dot(first_axis, half_chord), dot(second_axis, half_chord));
    const double reach = squared_length_of(begin.cwiseQuotient(radii));
    if (reach > 1) radii *= std::sqrt(reach);  // too small to span the chord
    const double away = std::sqrt(std::max(0.0, 1 / reach - 1)) * (large == sweep ? -1 : 1);
    const Vector2d centre(away * radii.x() / radii.y() * begin.y(),
                          -away * radii.y() / radii.x() * begin.x());

    const Vector2d from = (begin - centre).cwiseQuotient(radii);
    const Vector2d to = (-begin - centre).cwiseQuotient(radii);
    const double begin_angle = polar_angle(from.x(), from.y());
    double turn = polar_angle(to.x(), to.y()) - begin_angle;
    if (sweep && turn < 0) turn += 2 * std::numbers::pi;
    if (!sweep && turn > 0) turn -= 2 * std::numbers::pi;
    const Vector2d middle =
        (current_ + end) / 2 + centre.x() * first_axis + centre.y() * second_axis;
    const Vector2d u = turned(radii.x() * first_axis);
    const Vector2d v = turned(radii.y() * second_axis);
    const double radius = std::sqrt(squared_length_of(u) + squared_length_of(v));
    add_chords(std::abs(turn) * std::sqrt(radius / (8 * tolerance_)), [&](double t) -> Vector2d {
      const double angle = begin_angle + t * turn;
      return in_root(middle) + cosine(angle) * u + sine(angle) * v;
    });
  }

  Eigen::Affine2d root_from_path_;
  double tolerance_;
  Vector2d current_ = Vector2d::Zero();
  bool subpath_is_empty_ = true;
  FlatPath path_;
};

// Receives the transforms one by one, as they stand in the list.
struct TransformList {
  Eigen::Affine2d product = Eigen::Affine2d::Identity();

  void transform_matrix(const boost::array<double, 6>& m) {
    Eigen::Affine2d next;
    next.matrix() << m[0], m[2], m[4], m[1], m[3], m[5], 0, 0, 1;
    product = product * next;
  }
  void transform_translate(double x, double y) { transform_matrix({1, 0, 0, 1, x, y}); }
  void transform_scale(double x, double y) { transform_matrix({x, 0, 0, y, 0, 0}); }
  void transform_rotate(double degrees) {
    const double cos = cosine(radians(degrees));
    const double sin = sine(radians(degrees));
    transform_matrix({cos, sin, -sin, cos, 0, 0});
  }
  void transform_skew_x(double degrees) { transform_matrix({1, 0, tangent(degrees), 1, 0, 0}); }
  void transform_skew_y(double degrees) { transform_matrix({1, tangent(degrees), 0, 1, 0, 0}); }

 private:
  static double tangent(double degrees) {
    return sine(radians(degrees)) / cosine(radians(degrees));
  }
};

}  // namespace

std::optional<FlatPath> flatten_path_data(const std::string& data,
                                          const Eigen::Affine2d& root_from_path, double tolerance) {
  using Parser = svgpp::value_parser<svgpp::tag::type::path_data, svgpp::error_policy<AnswerFalse>>;
  Flattener flattener(root_from_path, tolerance);
  if (!Parser::parse(svgpp::tag::attribute::d(), flattener, data, svgpp::tag::source::attribute()))
    return std::nullopt;
  return flattener.path();
}

std::optional<Eigen::Affine2d> read_transform(const std::string& text) {
  using Parser =
      svgpp::value_parser<svgpp::tag::type::transform_list, svgpp::error_policy<AnswerFalse>,
                          svgpp::transform_policy<svgpp::policy::transform::minimal>>;
  TransformList list;
  if (!Parser::parse(svgpp::tag::attribute::transform(), list, text,
                     svgpp::tag::source::attribute()))
    return std::nullopt;
  return list.product;
}

}  // namespace ribbon
