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

#include "curve/heights.h"
#include "curve/place.h"
#include "curve/turns.h"
#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double steepest_slope = 1;   // rise per length in the plan
constexpr double blend_slope = 1.5;    // of the blend below, at its middle, per mean slope
constexpr double gentle_lead = 6;      // length per rise from an end to its first passage
constexpr double finest_turn = 0.003;  // radians per chord: lengths are right to 4e-7
constexpr double coarse_turn = 0.05;   // enough to find crossings
constexpr double most_chords = 5e5;

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

Result<void> same_crossings(const std::vector<DoublePoint>& drawn, const Controls& controls) {
  const Plan plan = smooth_plan(controls, coarse_turn, std::numeric_limits<double>::infinity());
  const auto smooth = find_double_points(plan.points);
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

// From one height to the other, level at both. Where passages alternate it is Catmull-Rom's cubic
// again: the levels before and after each are equal, and so its derivative there is 0.
double blend(const Level& a, const Level& b, double length) {
  if (b.length <= a.length) return b.height;
  const double t = std::clamp((length - a.length) / (b.length - a.length), 0.0, 1.0);
  return a.height + (b.height - a.height) * t * t * (3 - 2 * t);
}

WalkProfile profile_of(const std::vector<Passage>& passages, const Plan& plan) {
  WalkProfile profile;
  double before = 0;
  const auto add_way_to = [&](double here) {
    profile.rises.push_back((here - before) * steepest_slope / blend_slope);
    before = here;
  };
  for (const std::size_t i : plan.passages) add_way_to(plan.lengths[i]);
  add_way_to(plan.lengths.back());
  profile.crossings.resize(passages.size() / 2);
  for (std::size_t i = 0; i < passages.size(); ++i) {
    auto& [above, below] = profile.crossings[passages[i].crossing];
    (passages[i].over ? above : below) = i;
  }
  return profile;
}

// "from the start to passage 1", "from passage 2 to 3", "from passage 6 to the end".
std::string text_of(const Stretch& stretch, std::size_t passages) {
  const std::string from =
      stretch.from == 0 ? "the start" : "passage " + std::to_string(stretch.from);
  if (stretch.to == passages) return "from " + from + " to the end";
  return "from " + from + " to " + (stretch.from == 0 ? "passage " : "") +
         std::to_string(stretch.to + 1);
}

std::string text_of(const std::vector<Stretch>& stretches, std::size_t passages) {
  constexpr std::size_t most = 6;
  const std::size_t told = std::min(stretches.size(), most);
  std::string text = stretches.size() == 1 ? "the way " : "the ways ";
  for (std::size_t i = 0; i < told; ++i) {
    if (i > 0) text += i + 1 == stretches.size() ? " and " : ", ";
    text += text_of(stretches[i], passages);
  }
  const std::size_t rest = stretches.size() - told;
  if (rest > 0) text += " and " + std::to_string(rest) + " more";
  return text;
}

tl::unexpected<Error> too_tight(const CurveScene& scene, double width_m,
                                const std::vector<Passage>& passages, const TightCircle& tight) {
  const double length = tight.rise * blend_slope / steepest_slope;
  const double widest_m = tight.gap() * scene.unit_m - scene.clearance_m;
  const double needed = length * (width_m + scene.clearance_m) / (widest_m + scene.clearance_m);
  const std::size_t passage = std::min(tight.stretches.front().to, passages.size() - 1);
  const Vector2d place = passages[passage].point;
  const Vector2d metres = (place - scene.origin) * scene.unit_m;
  const bool one = tight.stretches.size() == 1;
  constexpr double spare = 1.01;  // so that the numbers hold although they are rounded
  return failure(
      drawing_place(place) + ", in metres " + coordinates(metres),
      text_of(tight.stretches, passages.size()) + (one ? " is " : " are together ") +
          three_digits(length * scene.unit_m) + " m long, too short for a ribbon " +
          three_digits(width_m) + " m wide",
      std::string(one ? "draw it " : "draw them together ") + three_digits(spare * needed) +
          " drawing units long" +
          (widest_m > 0 ? ", or set ribbon.width to " + three_digits(widest_m / spare) : ""));
}

// The heights along the plan: of the passages, and 0 towards both ends.
std::vector<Level> levels_of(const std::vector<double>& heights, const Plan& plan) {
  if (heights.empty()) return {{0, 0}};
  const auto lead = [](double height) { return gentle_lead * std::abs(height); };
  const double first = plan.lengths[plan.passages.front()];
  std::vector<Level> levels{{std::max(0.0, first - lead(heights.front())), 0}};
  for (std::size_t i = 0; i < heights.size(); ++i)
    levels.push_back({plan.lengths[plan.passages[i]], heights[i]});
  levels.push_back({std::min(plan.lengths.back(), levels.back().length + lead(heights.back())), 0});
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
  const auto drawing = read_drawing(scene);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto points_met_twice = find_double_points(drawing->points);
  if (!points_met_twice) return tl::unexpected(points_met_twice.error());
  const auto crossings = over_and_under(*points_met_twice, *drawing, scene);
  if (!crossings) return tl::unexpected(crossings.error());
  const auto passages = passages_along(*crossings);
  const Controls controls = controls_of(drawing->points, passages);
  if (auto same = same_crossings(*points_met_twice, controls); !same)
    return tl::unexpected(same.error());

  const double gap = (ribbon_width_m + scene.clearance_m) / scene.unit_m;
  Plan plan = fine_plan(controls, gap);
  SpaceCurve curve;
  const Heights heights = passage_heights(profile_of(passages, plan), gap);
  if (heights.tight) {
    const auto refusal = too_tight(scene, ribbon_width_m, passages, *heights.tight);
    if (tight_passage == TightPassage::refuse) return refusal;
    curve.squeezed = refusal.value();
    plan = fine_plan(controls, heights.gap);
  }
  auto points = raised(plan, levels_of(heights.passages, plan));
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
