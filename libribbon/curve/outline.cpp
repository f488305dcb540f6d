#include "curve/outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "curve/place.h"
#include "geometry/vectors.h"
#include "scene/setting.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;

constexpr std::size_t share_count = 1001;  // so that shares are round numbers
constexpr double outline_flatness = 1e-5;  // of its extent
constexpr double width_accuracy = 1e-3;    // of the widest
constexpr double end_inside = 1e-4;        // of the length: blunt ends are not quite square
constexpr double least_slimness = 2;       // length over width
constexpr double most_doubling = 1e-3;     // of the length
constexpr double most_asymmetry = 0.02;    // of the widest

// Coordinates along the long axis and across it.
struct LongAxis {
  Vector2d middle;
  Vector2d along;  // of length 1

  [[nodiscard]] Vector2d across() const { return {-along.y(), along.x()}; }
  [[nodiscard]] Vector2d seen(const Vector2d& point) const {
    const Vector2d arm = point - middle;
    return {dot(arm, along), dot(arm, across())};
  }
  [[nodiscard]] Vector2d drawn(const Vector2d& seen) const {
    return middle + seen.x() * along + seen.y() * across();
  }
};

template <class Use>
void for_each_edge(const Drawing& outline, Use use) {
  for (std::size_t i = 0; i < outline.size(); ++i)
    use(outline[i], outline[(i + 1) % outline.size()]);
}

Vector2d middle_of(const Drawing& outline) {
  double length = 0;
  Vector2d sum = Vector2d::Zero();
  for_each_edge(outline, [&](const Vector2d& a, const Vector2d& b) {
    length += length_of(b - a);
    sum += length_of(b - a) * (a + b) / 2;
  });
  return sum / length;
}

// The principal axis of the line as a bent wire: if that is symmetric, its axis of symmetry, also
// where it crosses itself.
LongAxis long_axis(const Drawing& outline) {
  const Vector2d middle = middle_of(outline);
  double difference = 0;
  double product = 0;
  for_each_edge(outline, [&](const Vector2d& a, const Vector2d& b) {
    const Vector2d arm = (a + b) / 2 - middle;
    const Vector2d edge = b - a;
    const double weight = length_of(edge);
    difference +=
        weight / 2 *
        (arm.x() * arm.x() - arm.y() * arm.y() + (edge.x() * edge.x() - edge.y() * edge.y()) / 12);
    product += weight * (arm.x() * arm.y() + edge.x() * edge.y() / 12);
  });
  const double reach = std::sqrt(difference * difference + product * product);
  if (reach == 0) return {middle, Vector2d::UnitX()};
  Vector2d along = normalised(difference >= 0 ? Vector2d(reach + difference, product)
                                              : Vector2d(product, reach - difference));
  const bool is_upright = std::abs(along.y()) > std::abs(along.x());
  if ((is_upright ? along.y() : along.x()) < 0) along = -along;
  return {middle, along};
}

// The corners as seen from the axis, and which of them are the ends.
struct SeenOutline {
  LongAxis axis;
  std::vector<Vector2d> corners = {};
  std::size_t begin = 0;
  std::size_t end = 0;

  [[nodiscard]] double length() const { return corners[end].x() - corners[begin].x(); }
  [[nodiscard]] double along_at(std::size_t share) const {
    const double t = static_cast<double>(share) / (share_count - 1);
    return corners[begin].x() + length() * std::clamp(t, end_inside, 1 - end_inside);
  }
  [[nodiscard]] std::string place(const Vector2d& seen) const {
    return drawing_place(axis.drawn(seen));
  }
};

SeenOutline seen_along_its_axis(const Drawing& outline) {
  SeenOutline seen{long_axis(outline)};
  for (const Vector2d& corner : outline) seen.corners.push_back(seen.axis.seen(corner));
  const auto [first, last] =
      std::minmax_element(seen.corners.begin(), seen.corners.end(),
                          [](const Vector2d& a, const Vector2d& b) { return a.x() < b.x(); });
  seen.begin = static_cast<std::size_t>(first - seen.corners.begin());
  seen.end = static_cast<std::size_t>(last - seen.corners.begin());
  return seen;
}

// One of the two ways from end to end; it never leads back.
using Side = std::vector<Vector2d>;

// By steps of so many corners, round the outline.
Result<Side> side_of(const SeenOutline& outline, std::size_t step) {
  Side side;
  double furthest = outline.corners[outline.begin].x();
  for (std::size_t i = outline.begin;; i = (i + step) % outline.corners.size()) {
    const Vector2d& corner = outline.corners[i];
    if (corner.x() < furthest - most_doubling * outline.length())
      return failure(outline.place(corner),
                     "the outline doubles back, so that one place of the band has several widths",
                     "draw both sides so that they lead from one end to the other");
    furthest = std::max(furthest, corner.x());
    side.emplace_back(furthest, corner.y());
    if (i == outline.end) return side;
  }
}

double across_at(const Side& side, double along) {
  const auto next =
      std::upper_bound(side.begin(), side.end(), along,
                       [](double wanted, const Vector2d& p) { return wanted < p.x(); });
  if (next == side.begin()) return side.front().y();
  if (next == side.end()) return side.back().y();
  const Vector2d& before = *std::prev(next);
  const double t = (along - before.x()) / (next->x() - before.x());
  return before.y() + t * (next->y() - before.y());
}

// At all shares.
struct Widths {
  std::vector<double> widths;
  std::vector<double> middles;  // between both sides, as seen from the axis
};

Widths between(const Side& first, const Side& second, const SeenOutline& outline) {
  Widths all;
  double sum = 0;
  for (std::size_t i = 0; i < share_count; ++i) {
    const double a = across_at(first, outline.along_at(i));
    const double b = across_at(second, outline.along_at(i));
    all.widths.push_back(a - b);
    all.middles.push_back((a + b) / 2);
    sum += a - b;
  }
  if (sum < 0)
    for (double& width : all.widths) width = -width;
  return all;
}

Result<void> is_slim(const SeenOutline& outline, const Widths& all) {
  const double widest = *std::max_element(all.widths.begin(), all.widths.end());
  if (outline.length() >= least_slimness * widest) return {};
  return failure(outline.place({0, 0}),
                 filled_in("the outline has no long axis: along it it measures {}, across {}",
                           short_number(outline.length(), 3), short_number(widest, 3)),
                 "draw it at least twice as long as wide");
}

Result<void> has_width_everywhere(const SeenOutline& outline, const Widths& all) {
  const auto none =
      std::find_if(all.widths.begin(), all.widths.end(), [](double width) { return !(width > 0); });
  if (none == all.widths.end()) return {};
  const auto share = static_cast<std::size_t>(none - all.widths.begin());
  return failure(outline.place({outline.along_at(share), all.middles[share]}),
                 "the outline has no width here: it crosses itself, or its sides meet",
                 "draw it as one line round the band, with blunt ends");
}

// Apart from as many shares at each end, the one whose middle lies furthest off the axis.
std::size_t worst_asymmetry(const std::vector<double>& middles, std::size_t margin) {
  const auto first = middles.begin() + static_cast<std::ptrdiff_t>(margin);
  const auto end = middles.end() - static_cast<std::ptrdiff_t>(margin);
  return static_cast<std::size_t>(
      std::max_element(first, end, [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      middles.begin());
}

// The ends last: a slant there may come of asymmetry elsewhere, which tilts the axis.
Result<void> is_symmetric(const SeenOutline& outline, const Widths& all) {
  for (const std::size_t margin : {share_count / 100, std::size_t{0}}) {
    const std::size_t share = worst_asymmetry(all.middles, margin);
    const double off = std::abs(all.middles[share]);
    if (off <= most_asymmetry * *std::max_element(all.widths.begin(), all.widths.end())) continue;
    const double half = all.widths[share] / 2;
    return failure(
        outline.place({outline.along_at(share), all.middles[share]}),
        filled_in("the outline is not symmetric about its long axis: on one side {} wide, on the "
                  "other {}",
                  short_number(half + off, 3), short_number(half - off, 3)),
        "draw one half of it, and mirror that");
  }
  return {};
}

double share_of_index(std::size_t index) {
  return static_cast<double>(index) / (share_count - 1);
}

// Where the profile errs most, and by how much.
std::pair<double, std::size_t> worst_told(const WidthProfile& profile,
                                          const std::vector<double>& widths) {
  std::pair<double, std::size_t> worst{0, 0};
  for (std::size_t i = 0; i < share_count; ++i)
    worst = std::max(worst, {std::abs(width_at_m(profile, share_of_index(i)) - widths[i]), i});
  return worst;
}

// Begins with both ends; what is told worst is added until all is told well.
WidthProfile few_points(const std::vector<double>& widths) {
  const double tolerance = width_accuracy * *std::max_element(widths.begin(), widths.end());
  WidthProfile profile{{{0, widths.front()}, {1, widths.back()}}};
  for (;;) {
    const auto [error, index] = worst_told(profile, widths);
    if (error <= tolerance) return profile;
    const WidthAt added{share_of_index(index), widths[index]};
    profile.points.insert(
        std::upper_bound(profile.points.begin(), profile.points.end(), added.share,
                         [](double share, const WidthAt& point) { return share < point.share; }),
        added);
  }
}

Result<SvgPath> path_of(const OutlineScene& outline) {
  if (auto there = check_readable(outline.file); !there) return tl::unexpected(there.error());
  const auto paths =
      find_svg_paths(outline.file.path, outline.path_id, {"[ribbon]", "outline_path"});
  if (!paths) return tl::unexpected(paths.error());
  if (paths->size() == 1) return paths->front();
  return failure(paths->front().place, "'" + outline.path_id + "' is a group of several paths",
                 "name the one that is the outline");
}

// Flattened twice: how fine depends on how large it is.
Result<WidthProfile> widths_drawn_by(const SvgPath& path) {
  const auto coarse = flattened_outline(path, std::numeric_limits<double>::max());
  if (!coarse) return tl::unexpected(coarse.error());
  const auto fine = flattened_outline(path, outline_flatness * extent_of(*coarse));
  if (!fine) return tl::unexpected(fine.error());
  return widths_of(*fine).map_error([&path](Error error) {
    error.place = path.place + ", " + error.place;
    return error;
  });
}

// "width = [[0, 0.02], [1, 0.09]]"
std::string entry_of(const WidthProfile& profile, double unit_m) {
  std::string list;
  for (const auto& [share, width] : profile.points)
    list += (list.empty() ? "" : ", ") +
            filled_in("[{}, {}]", short_number(share), short_number(width * unit_m));
  return "width = [" + list + "]";
}

// All else may have been changed since the scene was read.
Scene with_widths_of(const Scene& read, Scene scene) {
  scene.text = read.text;
  scene.ribbon.outline.reset();
  scene.ribbon.width_m = read.ribbon.width_m;
  scene.ribbon.profile = read.ribbon.profile;
  scene.ribbon.width_m = mean_width_m(scene.ribbon);
  if (scene.curve.clearance_m == 0) scene.curve.clearance_m = read.curve.clearance_m;
  return scene;
}

}  // namespace

Result<WidthProfile> widths_of(const Drawing& outline) {
  const SeenOutline seen = seen_along_its_axis(outline);
  const auto first = side_of(seen, 1);
  if (!first) return tl::unexpected(first.error());
  const auto second = side_of(seen, seen.corners.size() - 1);
  if (!second) return tl::unexpected(second.error());
  const Widths all = between(*first, *second, seen);
  for (const auto& check : {is_slim, has_width_everywhere, is_symmetric})
    if (auto passed = check(seen, all); !passed) return tl::unexpected(passed.error());
  return few_points(all.widths);
}

Result<Scene> with_outline_read(const Scene& scene) {
  const auto& outline = scene.ribbon.outline;
  if (!outline) return scene;
  const auto replaced = [&scene](std::string_view key, const std::string& words) {
    return [&scene, key, words](const std::string& text) {
      return with_entry_replaced(scene.file, text, "ribbon", key, words);
    };
  };
  const auto found =
      path_of(*outline)
          .and_then(widths_drawn_by)
          .and_then([&](const WidthProfile& profile) {
            return replaced("outline", entry_of(profile, scene.curve.unit_m))(scene.text);
          })
          .and_then(replaced("outline_path", ""))
          .and_then([&](std::string text) { return read_scene(scene.file, std::move(text)); });
  return found.map([&scene](const Scene& read) { return with_widths_of(read, scene); });
}

}  // namespace ribbon
