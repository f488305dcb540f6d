// Two pieces of the walk that come closer than a tolerance are a contact. Contacts that are one and
// the same meeting, for instance at a vertex where up to four pairs of segments meet, are joined.
// Whether the strands of a meeting cross is then read off a small circle around it: they do if and
// only if their four exits alternate on the circle. That needs no case for vertices.
#include "curve/crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "curve/place.h"
#include "curve/turns.h"
#include "geometry/lengths_along.h"
#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;

// All lengths in tolerances, all tolerances in the drawing's extent.
constexpr double tolerance_per_extent = 1e-4;  // strands that are nearer than this touch
constexpr double smallest_loop = 8;            // a shorter way along the walk is a corner
constexpr double same_meeting = 4;             // contacts this near along both strands are one
constexpr double longest_meeting = 50;         // strands that stay together longer overlap
// What comes after takes memory and time for each; a net of that many meshes is no knot.
constexpr std::size_t most_contacts = 20'000;
constexpr double smallest_angle = 0.03;  // radians; strands that cross flatter overlap

// The drawing measured by the length walked.
class Walk {
 public:
  explicit Walk(const Drawing& drawing) : points_(drawing), length_at_(lengths_along(drawing)) {
    Eigen::AlignedBox2d box(drawing.front());
    for (const Vector2d& point : drawing) box.extend(point);
    extent_ = box.diagonal();
    tolerance_ = tolerance_per_extent * length_of(extent_);
  }

  [[nodiscard]] double tolerance() const { return tolerance_; }
  [[nodiscard]] double length() const { return length_at_.back(); }
  [[nodiscard]] std::size_t segment_count() const { return points_.size() - 1; }
  [[nodiscard]] const Vector2d& point(std::size_t i) const { return points_[i]; }
  [[nodiscard]] int longer_coordinate() const { return extent_.x() >= extent_.y() ? 0 : 1; }

  [[nodiscard]] double length_at(std::size_t segment, double fraction) const {
    const double from_start = fraction * (length_at_[segment + 1] - length_at_[segment]);
    return length_at_[segment] + from_start;
  }
  [[nodiscard]] std::size_t segment_at(double length) const {
    const auto after = std::upper_bound(length_at_.begin(), length_at_.end(), length);
    const std::size_t i = std::max<std::ptrdiff_t>(std::distance(length_at_.begin(), after) - 1, 0);
    return std::min(i, segment_count() - 1);
  }
  [[nodiscard]] double parameter_at(double length) const {
    const std::size_t i = segment_at(length);
    return static_cast<double>(i) + (length - length_at_[i]) / (length_at_[i + 1] - length_at_[i]);
  }
  [[nodiscard]] Vector2d point_at(double length) const {
    const std::size_t i = segment_at(length);
    const double fraction = parameter_at(length) - static_cast<double>(i);
    return points_[i] + fraction * (points_[i + 1] - points_[i]);
  }

  // Where the walk from `begin` towards `end` (either way) leaves the circle; nothing if it stays.
  [[nodiscard]] std::optional<Vector2d> exit(double begin, double end, const Vector2d& centre,
                                             double radius) const;

 private:
  const Drawing& points_;
  std::vector<double> length_at_;
  Vector2d extent_;
  double tolerance_ = 0;
};

// The point of the segment from `inside` to `outside` on the circle.
Vector2d on_circle(const Vector2d& inside, const Vector2d& outside, const Vector2d& centre,
                   double radius) {
  const Vector2d way = outside - inside;
  const Vector2d from_centre = inside - centre;
  const double a = squared_length_of(way);
  const double b = dot(from_centre, way);
  const double c = squared_length_of(from_centre) - radius * radius;
  return inside + (std::sqrt(std::max(b * b - a * c, 0.0)) - b) / a * way;
}

std::optional<Vector2d> Walk::exit(double begin, double end, const Vector2d& centre,
                                   double radius) const {
  const bool forward = end > begin;
  const auto is_before_end = [&](std::size_t i) {
    return forward ? length_at_[i] < end : length_at_[i] > end;
  };
  Vector2d inside = point_at(begin);
  std::size_t i = segment_at(begin) + (forward ? 1 : 0);
  for (; is_before_end(i); forward ? ++i : --i) {
    if (length_of(points_[i] - centre) >= radius)
      return on_circle(inside, points_[i], centre, radius);
    inside = points_[i];
  }
  const Vector2d last = point_at(end);
  if (length_of(last - centre) < radius) return std::nullopt;
  return on_circle(inside, last, centre, radius);
}

struct Range {
  double begin = std::numeric_limits<double>::infinity();
  double end = -std::numeric_limits<double>::infinity();

  void extend(const Range& other) {
    begin = std::min(begin, other.begin);
    end = std::max(end, other.end);
  }
  [[nodiscard]] double length() const { return end - begin; }
  [[nodiscard]] bool is_within(double distance, const Range& other) const {
    return begin <= other.end + distance && other.begin <= end + distance;
  }
};

// Two pieces of the walk, by length, that are nearer than the tolerance; nearest at `first_length`
// and `second_length`.
struct Contact {
  Range first;
  Range second;
  double distance = std::numeric_limits<double>::infinity();
  double first_length = 0;
  double second_length = 0;

  void extend(const Contact& other) {
    first.extend(other.first);
    second.extend(other.second);
    if (other.distance >= distance) return;
    distance = other.distance;
    first_length = other.first_length;
    second_length = other.second_length;
  }
};

// Calls visit(i, j) for all pairs of segments, i < j, whose boxes are within the tolerance, until
// it says no: along the longer side of the drawing, each box meets only those that begin before it
// ends.
void for_near_segments(const Walk& walk,
                       const std::function<bool(std::size_t, std::size_t)>& visit) {
  const int along = walk.longer_coordinate();
  const Vector2d margin = Vector2d::Constant(walk.tolerance());
  std::vector<Eigen::AlignedBox2d> boxes;
  for (std::size_t i = 0; i < walk.segment_count(); ++i) {
    boxes.emplace_back(walk.point(i).cwiseMin(walk.point(i + 1)),
                       walk.point(i).cwiseMax(walk.point(i + 1)) + margin);
  }
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return boxes[i].min()[along] < boxes[j].min()[along];
  });
  for (auto i = order.begin(); i != order.end(); ++i)
    for (auto j = i + 1; j != order.end(); ++j) {
      if (boxes[*j].min()[along] > boxes[*i].max()[along]) break;
      if (boxes[*i].intersects(boxes[*j]) && !visit(std::min(*i, *j), std::max(*i, *j))) return;
    }
}

double nearest_fraction(const Vector2d& point, const Vector2d& a, const Vector2d& b) {
  return std::clamp(dot(point - a, b - a) / squared_length_of(b - a), 0.0, 1.0);
}

// What segments i < j have to do with each other; nothing but a corner between neighbours.
std::optional<Contact> contact_of(const Walk& walk, std::size_t i, std::size_t j) {
  const Vector2d& a = walk.point(i);
  const Vector2d& b = walk.point(i + 1);
  const Vector2d& c = walk.point(j);
  const Vector2d& d = walk.point(j + 1);
  Contact contact;
  const auto consider = [&](double on_first, double on_second) {
    const double s = walk.length_at(i, on_first);
    const double t = walk.length_at(j, on_second);
    const double distance = length_of(a + on_first * (b - a) - c - on_second * (d - c));
    if (distance <= walk.tolerance() && t - s > smallest_loop * walk.tolerance())
      contact.extend({{s, s}, {t, t}, distance, s, t});
  };
  const double side_a = cross(d - c, a - c);
  const double side_b = cross(d - c, b - c);
  const double side_c = cross(b - a, c - a);
  const double side_d = cross(b - a, d - a);
  if (side_a * side_b < 0 && side_c * side_d < 0)
    consider(side_a / (side_a - side_b), side_c / (side_c - side_d));
  consider(0, nearest_fraction(a, c, d));
  consider(1, nearest_fraction(b, c, d));
  consider(nearest_fraction(c, a, b), 0);
  consider(nearest_fraction(d, a, b), 1);
  if (std::isinf(contact.distance)) return std::nullopt;
  return contact;
}

Result<std::vector<Contact>> find_contacts(const Walk& walk) {
  std::vector<Contact> contacts;
  for_near_segments(walk, [&](std::size_t i, std::size_t j) {
    if (const auto contact = contact_of(walk, i, j)) contacts.push_back(*contact);
    return contacts.size() <= most_contacts;
  });
  if (contacts.size() > most_contacts)
    return failure(drawing_place(walk.point_at(contacts.back().first_length)),
                   "the curve meets itself in more than " + std::to_string(most_contacts) +
                       " places, here and elsewhere",
                   "draw a simpler curve");
  std::sort(contacts.begin(), contacts.end(), [](const Contact& a, const Contact& b) {
    return std::pair(a.first.begin, a.second.begin) < std::pair(b.first.begin, b.second.begin);
  });
  return contacts;
}

// Joins contacts that are one meeting; in order of the walk.
std::vector<Contact> find_meetings(const Walk& walk, const std::vector<Contact>& contacts) {
  const double near = same_meeting * walk.tolerance();
  std::vector<std::size_t> parent(contacts.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t j = i + 1;
         j < contacts.size() && contacts[i].first.is_within(near, contacts[j].first); ++j)
      if (contacts[i].second.is_within(near, contacts[j].second)) {
        const auto [low, high] = std::minmax({root(i), root(j)});
        parent[high] = low;
      }
  std::vector<Contact> joined(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) joined[root(i)].extend(contacts[i]);
  std::erase_if(joined, [](const Contact& contact) { return std::isinf(contact.distance); });
  return joined;
}

// How a meeting looks on a small circle around it.
struct Exits {
  std::array<Vector2d, 2> first;  // of the first strand: in, out; relative to the centre
  std::array<Vector2d, 2> second;
};

std::optional<Exits> exits_of(const Walk& walk, const Contact& meeting) {
  const Vector2d centre = walk.point_at(meeting.first_length);
  const double radius =
      2 * walk.tolerance() + std::max(meeting.first.length(), meeting.second.length());
  const double between = (meeting.first.end + meeting.second.begin) / 2;
  const auto exit = [&](double begin, double end) { return walk.exit(begin, end, centre, radius); };
  const auto first_in = exit(meeting.first.begin, 0);
  const auto first_out = exit(meeting.first.end, between);
  const auto second_in = exit(meeting.second.begin, between);
  const auto second_out = exit(meeting.second.end, walk.length());
  if (!first_in || !first_out || !second_in || !second_out) return std::nullopt;
  return Exits{{*first_in - centre, *first_out - centre},
               {*second_in - centre, *second_out - centre}};
}

double flattest_angle(const Exits& exits) {
  double angle = std::numbers::pi;
  for (const Vector2d& a : exits.first)
    for (const Vector2d& b : exits.second) angle = std::min(angle, angle_between(a, b));
  return angle;
}

// Whether `direction` is met when the circle is walked counter-clockwise from a to b.
bool is_in_arc(const Vector2d& direction, const Vector2d& a, const Vector2d& b) {
  const auto counter_clockwise = [&](const Vector2d& to) {
    const double turn = turn_from(a, to);
    return turn < 0 ? turn + 2 * std::numbers::pi : turn;
  };
  return counter_clockwise(direction) < counter_clockwise(b);
}

bool strands_cross(const Exits& exits) {
  return is_in_arc(exits.second[0], exits.first[0], exits.first[1]) !=
         is_in_arc(exits.second[1], exits.first[0], exits.first[1]);
}

// +1 if the second strand passes the first from its right to its left as seen on the screen, where
// y grows downwards: the sign of the crossing if the first strand is over.
int sign_if_first_is_over(const Exits& exits) {
  const Vector2d first = exits.first[1] - exits.first[0];
  const Vector2d second = exits.second[1] - exits.second[0];
  return cross(first, second) < 0 ? 1 : -1;
}

// A meeting that proved to be a crossing.
struct Passages {
  double first_length;
  double second_length;
  int sign_if_first_is_over;
};

Result<Passages> told_apart(const Walk& walk, const Contact& meeting) {
  const std::string place = drawing_place(walk.point_at(meeting.first_length));
  const auto overlap = [&] {
    return failure(place, "two pieces of the curve run along each other",
                   "draw them apart or let them cross at an open angle");
  };
  if (std::max(meeting.first.length(), meeting.second.length()) >
      longest_meeting * walk.tolerance())
    return overlap();
  const auto exits = exits_of(walk, meeting);
  if (!exits)
    return failure(place, "an end of the curve touches it, or a loop is too small to be told",
                   "draw the end clear of the curve, or the loop larger");
  if (flattest_angle(*exits) < smallest_angle) return overlap();
  if (!strands_cross(*exits))
    return failure(place, "two pieces of the curve touch without crossing",
                   "draw them apart or let them cross");
  return Passages{meeting.first_length, meeting.second_length, sign_if_first_is_over(*exits)};
}

// One of the two visits to a crossing.
struct Visit {
  double length;
  std::size_t crossing;
};

std::vector<Visit> visits_along_walk(const std::vector<Passages>& crossings) {
  std::vector<Visit> visits;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    visits.push_back({crossings[i].first_length, i});
    visits.push_back({crossings[i].second_length, i});
  }
  std::sort(visits.begin(), visits.end(),
            [](const Visit& a, const Visit& b) { return a.length < b.length; });
  return visits;
}

Result<void> no_triple_points(const Walk& walk, const std::vector<Visit>& visits) {
  for (std::size_t i = 1; i < visits.size(); ++i)
    if (visits[i].crossing != visits[i - 1].crossing &&
        visits[i].length - visits[i - 1].length <= same_meeting * walk.tolerance())
      return failure(drawing_place(walk.point_at(visits[i].length)),
                     "three pieces of the curve pass through one point",
                     "move one of them aside, so that each crossing is of two");
  return {};
}

}  // namespace

Result<std::vector<DoublePoint>> find_double_points(const Drawing& drawing) {
  const Walk walk(drawing);
  const auto contacts = find_contacts(walk);
  if (!contacts) return tl::unexpected(contacts.error());
  std::vector<Passages> passages;
  for (const Contact& meeting : find_meetings(walk, *contacts)) {
    const auto told = told_apart(walk, meeting);
    if (!told) return tl::unexpected(told.error());
    passages.push_back(*told);
  }
  std::sort(passages.begin(), passages.end(),
            [](const Passages& a, const Passages& b) { return a.first_length < b.first_length; });
  if (auto apart = no_triple_points(walk, visits_along_walk(passages)); !apart)
    return tl::unexpected(apart.error());
  std::vector<DoublePoint> points;
  points.reserve(passages.size());
  for (const Passages& p : passages)
    points.push_back({walk.parameter_at(p.first_length), walk.parameter_at(p.second_length),
                      walk.point_at(p.first_length), p.sign_if_first_is_over});
  return points;
}

}  // namespace ribbon
