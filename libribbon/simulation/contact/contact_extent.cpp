#include "simulation/contact/contact_extent.h"

#include <algorithm>
#include <span>
#include <vector>

#include "geometry/vectors.h"
#include "simulation/detection/closest_weights.h"
#include "simulation/detection/vertex_ranges.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr double touching = 1.5;  // of the distance at which contact begins

enum class Touches : char { nothing, obstacle, ribbon };

// Of the same quad or of neighbours: the shear of what lies side by side brings them together.
bool are_side_by_side(const FeaturePair& pair, const RibbonGrid& grid) {
  const auto first = pair.vertices.begin();
  const auto second = first + first_count(pair.kind);
  const auto steps_apart = [&](const auto& place_of) {
    const auto before = [&](int a, int b) { return place_of(a) < place_of(b); };
    const auto [low_a, high_a] = std::minmax_element(first, second, before);
    const auto [low_b, high_b] = std::minmax_element(second, pair.vertices.end(), before);
    return std::max(place_of(*low_b) - place_of(*high_a), place_of(*low_a) - place_of(*high_b));
  };
  return steps_apart([&](int particle) { return grid.row(particle); }) <= 1 &&
         steps_apart([&](int particle) { return grid.column(particle); }) <= 1;
}

bool touch(const FeaturePair& pair, const PairDistances& distances,
           const VertexPositions& positions) {
  const auto x = corners(pair, positions);
  return length_of(weighted_sum(x, closest_weights(pair.kind, x))) <=
         touching * distances.activation_m(pair);
}

// What the rows are found to touch, by all cores at a time: in whatever order pairs are looked at,
// the same rows touch in the end. (By the compilers' own functions: libc++ has no std::atomic_ref.)
class TouchedRows {
 public:
  explicit TouchedRows(int rows) : touched_(rows, Touches::nothing) {}

  // Is it not yet known that the row touches so much?
  [[nodiscard]] bool is_news(int row, Touches what) const {
    Touches known = Touches::nothing;
    __atomic_load(&touched_[row], &known, __ATOMIC_RELAXED);
    return known < what;
  }
  void set(int row, Touches what) { __atomic_store(&touched_[row], &what, __ATOMIC_RELAXED); }
  [[nodiscard]] const std::vector<Touches>& all() const { return touched_; }

 private:
  std::vector<Touches> touched_;
};

// Most pairs of a knot tell nothing new about their rows: distances take time, and so do lists.
std::vector<Touches> touched_rows(Bodies& bodies, const PairDistances& distances,
                                  const Matrix3Xd& positions) {
  const VertexPositions vertices = bodies.vertices(positions);
  TouchedRows rows(bodies.grid.along);
  const auto look_for = [&](Touches what) {
    const auto is_wanted = [&rows, what](const RibbonBvh::Rows& part) {
      for (int row = part.first; row <= part.last; ++row)
        if (rows.is_news(row, what)) return true;
      return false;
    };
    const auto take = [&, what](std::span<const FeaturePair> pairs) {
      for (const FeaturePair& pair : pairs) {
        const auto is_news = [&](int vertex) {
          return bodies.is_particle(vertex) && rows.is_news(bodies.grid.row(vertex), what);
        };
        if (std::none_of(pair.vertices.begin(), pair.vertices.end(), is_news)) continue;
        if (what == Touches::ribbon && are_side_by_side(pair, bodies.grid)) continue;
        if (!touch(pair, distances, vertices)) continue;
        for (const int vertex : pair.vertices)
          if (is_news(vertex)) rows.set(bodies.grid.row(vertex), what);
      }
    };
    if (what == Touches::ribbon)
      bodies.ribbon_bvh.visit_within(is_wanted, take);
    else if (const auto& obstacle = bodies.obstacle)
      bodies.ribbon_bvh.visit_with(obstacle->surface, obstacle->bvh, obstacle->vertices, is_wanted,
                                   take);
  };
  bodies.ribbon_bvh.refit(vertex_ranges(positions, positions),
                          touching * distances.largest_activation_m());
  look_for(Touches::ribbon);
  look_for(Touches::obstacle);
  return rows.all();
}

}  // namespace

ContactExtent contact_extent(Bodies& bodies, const RestSize& size, const PairDistances& distances,
                             const Matrix3Xd& positions) {
  const std::vector<Touches> rows = touched_rows(bodies, distances, positions);
  const auto free = std::count(rows.begin(), rows.end(), Touches::nothing);
  ContactExtent extent;
  extent.share = 1 - static_cast<double>(free) / static_cast<double>(rows.size());
  const auto first = std::find(rows.begin(), rows.end(), Touches::ribbon);
  const auto last = std::find(rows.rbegin(), rows.rend(), Touches::ribbon);
  if (first == rows.end()) return extent;
  extent.knotted_m = size.along_m() * static_cast<double>(last.base() - first - 1);
  extent.loose_ends_m = {size.along_m() * static_cast<double>(first - rows.begin()),
                         size.along_m() * static_cast<double>(last - rows.rbegin())};
  return extent;
}

}  // namespace ribbon
