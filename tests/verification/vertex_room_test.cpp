#include "verification/vertex_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "verification/feature_distance.h"
#include "verification/soups.h"

namespace ribbon::vertex_room_test {

constexpr double reach_m = 3;

std::vector<double> found_by_tree(const TriangleSoup& soup) {
  const BoxTree judged(soup, 0, soup.judged);
  const BoxTree rest(soup, soup.judged, static_cast<int>(soup.triangles.cols()));
  return vertex_room(soup, FeatureOwners(soup.triangles), judged, rest, reach_m);
}

bool differ(std::initializer_list<int> vertices) {
  return std::set<int>(vertices).size() == vertices.size();
}

// Corner i of t against u.
void measure_corner(const TriangleSoup& soup, int t, int i, int u, std::vector<double>& gaps) {
  const int corner = soup.triangles(i, t);
  const auto c = soup.triangles.col(u);
  if (!differ({corner, c[0], c[1], c[2]})) return;
  const double distance = certain_point_triangle_distance(
      soup.points.col(corner), soup.points.col(c[0]), soup.points.col(c[1]), soup.points.col(c[2]));
  for (const int vertex : {corner, c[0], c[1], c[2]})
    gaps[vertex] = std::min(gaps[vertex], distance);
}

void measure_edges(const TriangleSoup& soup, int t, int i, int u, int j,
                   std::vector<double>& gaps) {
  const std::array v = {soup.triangles(i, t), soup.triangles((i + 1) % 3, t), soup.triangles(j, u),
                        soup.triangles((j + 1) % 3, u)};
  if (!differ({v[0], v[1], v[2], v[3]})) return;
  const double distance = certain_segments_distance(soup.points.col(v[0]), soup.points.col(v[1]),
                                                    soup.points.col(v[2]), soup.points.col(v[3]));
  for (const int vertex : v) gaps[vertex] = std::min(gaps[vertex], distance);
}

std::vector<double> brute_force(const TriangleSoup& soup) {
  std::vector<double> gaps(soup.points.cols(), reach_m);
  for_every_pair(soup, [&](const TrianglePair& pair) {
    for (int i = 0; i < 3; ++i) {
      measure_corner(soup, pair.first, i, pair.second, gaps);
      measure_corner(soup, pair.second, i, pair.first, gaps);
      for (int j = 0; j < 3; ++j) measure_edges(soup, pair.first, i, pair.second, j, gaps);
    }
  });
  return gaps;
}

TEST(VertexRoom, is_that_that_measuring_every_pair_finds) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    TriangleSoup soup = random_soup(seed, 40, 20, {.lowest = -8, .highest = 8, .unit = 1});
    soup.judged = 12;
    const std::vector<double> found = found_by_tree(soup);
    const std::vector<double> expected = brute_force(soup);
    for (std::size_t vertex = 0; vertex < expected.size(); ++vertex)
      EXPECT_NEAR(found[vertex], expected[vertex], 1e-9) << "seed " << seed << ", " << vertex;
  }
}

}  // namespace ribbon::vertex_room_test
