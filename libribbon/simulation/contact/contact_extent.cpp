#include "simulation/contact/contact_extent.h"

#include <algorithm>
#include <vector>

#include "geometry/vectors.h"
#include "simulation/detection/closest_weights.h"
#include "simulation/detection/swept_pairs.h"
#include "simulation/detection/vertex_ranges.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr double touching = 1.5;  // of the distance at which contact begins

enum class Touches : char { nothing, obstacle, ribbon };

bool touch(const FeaturePair& pair, const PairDistances& distances,
           const VertexPositions& positions) {
  const auto x = corners(pair, positions);
  return length_of(weighted_sum(x, closest_weights(pair.kind, x))) <=
         touching * distances.activation_m(pair);
}

std::vector<Touches> touched_rows(Bodies& bodies, const PairDistances& distances,
                                  const Matrix3Xd& positions) {
  const VertexPositions vertices = bodies.vertices(positions);
  std::vector<Touches> rows(bodies.grid.along, Touches::nothing);
  const double reach_m = touching * distances.largest_activation_m();
  const auto row_of = [&](int particle) -> Touches& { return rows[bodies.grid.row(particle)]; };
  for (const FeaturePair& pair :
       pairs_within_ranges(bodies, vertex_ranges(positions, positions), reach_m)) {
    const bool with_obstacle = std::any_of(pair.vertices.begin(), pair.vertices.end(),
                                           [&](int vertex) { return !bodies.is_particle(vertex); });
    const Touches what = with_obstacle ? Touches::obstacle : Touches::ribbon;
    const auto is_news = [&](int vertex) {
      return bodies.is_particle(vertex) && row_of(vertex) < what;
    };
    // Most pairs of a knot tell nothing new, and distances take time.
    if (std::none_of(pair.vertices.begin(), pair.vertices.end(), is_news)) continue;
    if (!touch(pair, distances, vertices)) continue;
    for (const int vertex : pair.vertices)
      if (is_news(vertex)) row_of(vertex) = what;
  }
  return rows;
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
  if (first != rows.end())
    extent.knotted_m = size.along_m() * static_cast<double>(last.base() - first - 1);
  return extent;
}

}  // namespace ribbon
