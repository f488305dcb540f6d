// Everything up to the last step happens in drawing units, so that an error can name a place that
// the user finds in the drawing.
#include "curve/space_curve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <variant>

#include "curve/place.h"
#include "curve/turns.h"
#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double flatness_per_extent = 1e-5;  // a tenth of what find_crossings calls touching
constexpr double steepest_slope = 1;          // rise per length in the plan
constexpr double blend_slope = 1.5;           // of the blend below, at its middle, per mean slope
constexpr double gentle_lead = 6;             // length per rise from an end to its first passage
constexpr double finest_turn = 0.003;         // radians per chord: lengths are right to 4e-7
constexpr double coarse_turn = 0.05;          // enough to find crossings
constexpr double most_chords = 5e5;
constexpr double squeezed_per_widest = 0.999;  // so that rounding does not make it too wide again

Result<Drawing> read_drawing(const DrawnPoints& drawn) {
  Drawing drawing;
  for (const Vector2d& point : drawn.points) {
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > 1e9)
      return failure("drawing", "a point lies beyond 1e9 drawing units", "correct it");
    if (drawing.empty() || drawing.back() != point) drawing.push_back(point);
  }
  if (drawing.size() < 2)
    return failure("drawing", "the points have no length", "give at least two different points");
  return drawing;
}

// Flattened twice: how fine depends on how large the drawing is.
Result<Drawing> read_drawing(const DrawnSvg& drawn) {
  if (auto there = check_readable(drawn.file); !there) return tl::unexpected(there.error());
  const auto path = find_svg_path(drawn.file.path, drawn.path_id);
  if (!path) return tl::unexpected(path.error());
  auto coarse = flattened(*path, std::numeric_limits<double>::max());
  if (!coarse) return coarse;
  return flattened(*path, flatness_per_extent * extent_of(*coarse));
}

// One of the two visits of the walk to a crossing.
struct Passage {
  double parameter = 0;  // in the drawing
  bool over = false;
  Vector2d point;
};

std::vector<Passage> passages_along(const std::vector<Crossing>& crossings) {
  std::vector<Passage> passages;
  for (const Crossing& crossing : crossings) {
    passages.push_back({crossing.first, crossing.first_over, crossing.point});
    passages.push_back({crossing.second, !crossing.first_over, crossing.point});
  }
  std::sort(passages.begin(), passages.end(),
            [](const Passage& a, const Passage& b) { return a.parameter < b.parameter; });
  return passages;
}

// What the smooth curve passes through: the drawing's own points and its passages.
struct Controls {
  Drawing points;
  std::vector<std::size_t> passages;  // their indices in `points`
};

Controls controls_of(const Drawing& drawing, const std::vector<Passage>& passages) {
  const double near = 1e-6 * extent_of(drawing);
  Controls controls;
  const auto is_new = [&](const Vector2d& point) {
    return controls.points.empty() || length_of(point - controls.points.back()) > near;
  };
  auto passage = passages.begin();
  for (std::size_t i = 0; i < drawing.size(); ++i) {
    if (is_new(drawing[i])) controls.points.push_back(drawing[i]);
    for (; passage != passages.end() && passage->parameter < static_cast<double>(i + 1);
         ++passage) {
      if (is_new(passage->point)) controls.points.push_back(passage->point);
      controls.passages.push_back(controls.points.size() - 1);
    }
  }
  return controls;
}

// A cubic by its ends and its derivatives there.
template <class Vector>
struct Cubic {
  Vector begin, begin_derivative, end, end_derivative;

  [[nodiscard]] Vector at(double t) const {
    const double u = 1 - t;
    return u * u * (1 + 2 * t) * begin + u * u * t * begin_derivative + t * t * (1 + 2 * u) * end -
           t * t * u * end_derivative;
  }
};

// The derivative at p1 by the knots of p0, p1, p2, for a parameter that grows by 1 over `scale`.
template <class Vector>
Vector catmull_rom_derivative(const Vector& p0, const Vector& p1, const Vector& p2, double scale) {
  const double before = std::sqrt(length_of(p1 - p0));
  const double after = std::sqrt(length_of(p2 - p1));
  assert(before > 0 && after > 0);
  return scale * ((p1 - p0) / before - (p2 - p0) / (before + after) + (p2 - p1) / after);
}

template <class Vector>
Cubic<Vector> catmull_rom_cubic(const Vector& p0, const Vector& p1, const Vector& p2,
                                const Vector& p3) {
  const double knots = std::sqrt(length_of(p2 - p1));
  return {p1, catmull_rom_derivative(p0, p1, p2, knots), p2,
          catmull_rom_derivative(p1, p2, p3, knots)};
}

// Between controls i and i + 1; beyond its ends the curve goes straight on.
Cubic<Vector2d> cubic_between(const Drawing& points, std::size_t i) {
  const Vector2d& p1 = points[i];
  const Vector2d& p2 = points[i + 1];
  const Vector2d before = i == 0 ? Vector2d(2 * p1 - p2) : points[i - 1];
  const Vector2d after = i + 2 == points.size() ? Vector2d(2 * p2 - p1) : points[i + 2];
  return catmull_rom_cubic(before, p1, p2, after);
}

// No less than what the cubic turns by: the turns of its Bezier polygon.
double turn_of(const Cubic<Vector2d>& cubic) {
  const Vector2d b1 = cubic.begin + cubic.begin_derivative / 3;
  const Vector2d b2 = cubic.end - cubic.end_derivative / 3;
  return angle_between(cubic.begin_derivative, b2 - b1) +
         angle_between(b2 - b1, cubic.end_derivative);
}

// The smoothed plan as fine chords, and where in it the passages are.
struct Plan {
  Drawing points;
  std::vector<std::size_t> passages;
  std::vector<double> lengths = {};  // along it, up to each point
};

template <class Points>
std::vector<double> lengths_along(const Points& points) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < points.size(); ++i)
    lengths.push_back(lengths.back() + length_of(points[i] - points[i - 1]));
  return lengths;
}

Plan smooth_plan(const Controls& controls, double chord_turn, double chord_length) {
  Plan plan{{controls.points.front()}, {}};
  auto passage = controls.passages.begin();
  for (std::size_t i = 0; i < controls.points.size(); ++i) {
    for (; passage != controls.passages.end() && *passage == i; ++passage)
      plan.passages.push_back(plan.points.size() - 1);
    if (i + 1 == controls.points.size()) break;
    const auto cubic = cubic_between(controls.points, i);
    const double wanted =
        std::max(turn_of(cubic) / chord_turn, length_of(cubic.end - cubic.begin) / chord_length);
    const auto chords = static_cast<std::size_t>(std::ceil(std::max(wanted, 1.0)));
    for (std::size_t k = 1; k <= chords; ++k)
      plan.points.push_back(cubic.at(static_cast<double>(k) / static_cast<double>(chords)));
  }
  return plan;
}

// Fine enough to measure lengths, both in the plan and along the rises of `rise`.
Plan fine_plan(const Controls& controls, double rise) {
  double turn = 0;
  double length = 0;
  for (std::size_t i = 0; i + 1 < controls.points.size(); ++i) {
    turn += turn_of(cubic_between(controls.points, i));
    length += length_of(controls.points[i + 1] - controls.points[i]);
  }
  // A blend at the steepest slope turns by at most 8 / 3 radians over a length of its rise.
  const double chord_length = rise * finest_turn * 3 / 8;
  Plan plan = smooth_plan(controls, std::max(finest_turn, turn / most_chords),
                          std::max(chord_length, length / most_chords));
  plan.lengths = lengths_along(plan.points);
  return plan;
}

Result<void> same_crossings(const std::vector<Crossing>& drawn, const Controls& controls) {
  const Plan plan = smooth_plan(controls, coarse_turn, std::numeric_limits<double>::infinity());
  const auto smooth = find_crossings(plan.points, true);
  const std::string remedy = "draw more points there, or the strands further apart";
  if (!smooth)
    return failure(smooth.error().place, "once smoothed, " + smooth.error().problem, remedy);
  const double near = 1e-3 * extent_of(plan.points);
  for (std::size_t i = 0; i < std::max(drawn.size(), smooth->size()); ++i) {
    if (i < drawn.size() && i < smooth->size() &&
        length_of(drawn[i].point - (*smooth)[i].point) < near)
      continue;
    return failure(drawing_place(i < smooth->size() ? (*smooth)[i].point : drawn[i].point),
                   "the smoothed curve crosses itself otherwise than the drawing", remedy);
  }
  return {};
}

// A place of the walk, by length in the plan, whose height is given; the curve is level there.
struct Level {
  double length = 0;
  double height = 0;
};

// From one height to the other, level at both. It is Catmull-Rom's cubic again: since passages
// alternate, the levels before and after each are equal, and so its derivative there is 0.
double blend(const Level& a, const Level& b, double length) {
  if (b.length <= a.length) return b.height;
  const double t = std::clamp((length - a.length) / (b.length - a.length), 0.0, 1.0);
  return a.height + (b.height - a.height) * t * t * (3 - 2 * t);
}

// The way to a passage from the one before, or between an end and the passage next to it.
struct Way {
  double length = 0;
  double rise = 0;  // in gaps between the bands: 1 between passages, 1/2 at the ends
  Vector2d place;   // of the crossing
  std::string name;
};

std::vector<Way> ways_of(const std::vector<Passage>& passages, const Plan& plan) {
  std::vector<Way> ways;
  double before = 0;
  for (std::size_t i = 0; i < passages.size(); ++i) {
    const double here = plan.lengths[plan.passages[i]];
    const bool is_first = i == 0;
    ways.push_back({here - before, is_first ? 0.5 : 1, passages[i].point,
                    is_first ? "from the start to the first crossing"
                             : "from the crossing before to this one"});
    before = here;
  }
  ways.push_back({plan.lengths.back() - before, 0.5, passages.back().point,
                  "from the last crossing to the end"});
  return ways;
}

Way tightest_of(const std::vector<Way>& ways) {
  return *std::max_element(ways.begin(), ways.end(), [](const Way& a, const Way& b) {
    return a.rise * b.length < b.rise * a.length;
  });
}

double length_per_gap(const Way& way) {
  return blend_slope * way.rise / steepest_slope;
}

// Of bands whose middles are that far apart, the curve rises at the steepest slope.
double widest_gap(const Way& way) {
  return way.length / length_per_gap(way);
}

// The tightest passage, where it is too tight for the gap.
std::optional<Way> too_tight_passage(const std::vector<Passage>& passages, const Plan& plan,
                                     double gap) {
  if (passages.empty()) return std::nullopt;
  const Way tightest = tightest_of(ways_of(passages, plan));
  return gap > widest_gap(tightest) ? std::optional(tightest) : std::nullopt;
}

tl::unexpected<Error> too_tight(const CurveScene& scene, double width_m, const Way& way) {
  const double widest_m = way.length * scene.unit_m / length_per_gap(way) - scene.clearance_m;
  const double needed = length_per_gap(way) * (width_m + scene.clearance_m) / scene.unit_m;
  const Vector2d metres = (way.place - scene.origin) * scene.unit_m;
  constexpr double spare = 1.01;  // so that the numbers hold although they are rounded
  return failure(
      drawing_place(way.place) + ", in metres " + coordinates(metres),
      "the way " + way.name + " is " + three_digits(way.length * scene.unit_m) +
          " m, too short for a ribbon " + three_digits(width_m) + " m wide",
      "draw it " + three_digits(spare * needed) + " drawing units long" +
          (widest_m > 0 ? ", or set ribbon.width to " + three_digits(widest_m / spare) : ""));
}

// The heights along the plan: up and down at the passages, 0 towards both ends.
std::vector<Level> levels_of(const std::vector<Passage>& passages, const Plan& plan,
                             double height) {
  if (passages.empty()) return {{0, 0}};
  const double lead = gentle_lead * height;
  std::vector<Level> levels{{std::max(0.0, plan.lengths[plan.passages.front()] - lead), 0}};
  for (std::size_t i = 0; i < passages.size(); ++i)
    levels.push_back({plan.lengths[plan.passages[i]], passages[i].over ? height : -height});
  levels.push_back({std::min(plan.lengths.back(), levels.back().length + lead), 0});
  return levels;
}

std::vector<Vector3d> raised(const Plan& plan, const std::vector<Level>& levels) {
  std::vector<Vector3d> points;
  std::size_t next = 0;
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    while (next + 1 < levels.size() && levels[next].length <= plan.lengths[i]) ++next;
    const Level& before = levels[next == 0 ? 0 : next - 1];
    points.emplace_back(plan.points[i].x(), plan.points[i].y(),
                        blend(before, levels[next], plan.lengths[i]));
  }
  return points;
}

// From plan and height to the world, for a viewer at the positive end of the axis to whom the
// drawing's x points to the right and its y down.
Vector3d in_world(const Vector3d& p, Axis axis) {
  if (axis == Axis::y) return {p.x(), p.z(), p.y()};
  if (axis == Axis::z) return {p.x(), -p.y(), p.z()};
  return {p.z(), -p.y(), -p.x()};
}

Eigen::Matrix3Xd evenly_sampled(const std::vector<Vector3d>& points,
                                const std::vector<double>& lengths, int samples) {
  Eigen::Matrix3Xd result(3, samples);
  std::size_t i = 0;
  for (int k = 0; k < samples; ++k) {
    const double length = lengths.back() * k / (samples - 1);
    while (i + 2 < points.size() && lengths[i + 1] < length) ++i;
    const double t = std::clamp((length - lengths[i]) / (lengths[i + 1] - lengths[i]), 0.0, 1.0);
    result.col(k) = points[i] + t * (points[i + 1] - points[i]);
  }
  return result;
}

}  // namespace

Vector3d catmull_rom(const Vector3d& p0, const Vector3d& p1, const Vector3d& p2, const Vector3d& p3,
                     double t) {
  return catmull_rom_cubic(p0, p1, p2, p3).at(t);
}

Result<SpaceCurve> generate_space_curve(const CurveScene& scene, double ribbon_width_m, int samples,
                                        TightPassage tight_passage) {
  assert(samples >= 2 && scene.unit_m > 0 && ribbon_width_m > 0 && scene.clearance_m >= 0);
  const auto drawing =
      std::visit([](const auto& drawn) { return read_drawing(drawn); }, scene.drawing);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto crossings = find_crossings(*drawing, scene.first_passage_over);
  if (!crossings) return tl::unexpected(crossings.error());
  const auto passages = passages_along(*crossings);
  const Controls controls = controls_of(*drawing, passages);
  if (auto same = same_crossings(*crossings, controls); !same) return tl::unexpected(same.error());

  double gap = (ribbon_width_m + scene.clearance_m) / scene.unit_m;
  Plan plan = fine_plan(controls, gap);
  SpaceCurve curve;
  if (const auto tight = too_tight_passage(passages, plan, gap)) {
    const auto refusal = too_tight(scene, ribbon_width_m, *tight);
    if (tight_passage == TightPassage::refuse) return refusal;
    curve.squeezed = refusal.value();
    gap = squeezed_per_widest * (widest_gap(*tight) * scene.unit_m) / scene.unit_m;
    plan = fine_plan(controls, gap);
  }
  auto points = raised(plan, levels_of(passages, plan, gap / 2));
  for (Vector3d& point : points) {
    point.head<2>() -= scene.origin;
    point = in_world(point * scene.unit_m, scene.axis);
  }
  const auto lengths = lengths_along(points);
  curve.points = evenly_sampled(points, lengths, samples);
  curve.length_m = lengths.back();
  curve.crossings = *crossings;
  return curve;
}

}  // namespace ribbon
