#include "simulation/detection/swept_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "simulation/detection/closest_weights.h"
#include "simulation/detection/vertex_ranges.h"
#include "simulation/published/planted_penetrations.h"

namespace ribbon::swept_pairs_test {

using Eigen::Matrix3Xd;
using Kind = FeaturePair::Kind;
using Features = std::array<std::vector<int>, 2>;  // vertices of two features, sorted

constexpr double margin_m = 0.05;

Features sorted(std::vector<int> a, std::vector<int> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a.size() == b.size() && b < a ? Features{b, a} : Features{a, b};
}

Features features(const FeaturePair& pair) {
  const auto& v = pair.vertices;
  return pair.kind == Kind::vertex_triangle ? sorted({v[0]}, {v[1], v[2], v[3]})
                                            : sorted({v[0], v[1]}, {v[2], v[3]});
}

// Everything over which brute force looks for pairs: each feature once.
struct Shape {
  std::set<std::vector<int>> vertices;
  std::set<std::vector<int>> edges;
  std::set<std::vector<int>> triangles;
};

Shape shape_of(const Eigen::Matrix3Xi& triangles) {
  Shape shape;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    shape.triangles.insert({triangles(0, t), triangles(1, t), triangles(2, t)});
    for (int corner = 0; corner < 3; ++corner) {
      const int a = triangles(corner, t);
      const int b = triangles((corner + 1) % 3, t);
      shape.vertices.insert({a});
      shape.edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return shape;
}

class BruteForce {
 public:
  BruteForce(const Matrix3Xd& t0, const Matrix3Xd& t1) : t0_(t0), t1_(t1) {}

  void look(const std::set<std::vector<int>>& first, const std::set<std::vector<int>>& second) {
    for (const auto& a : first)
      for (const auto& b : second)
        if (std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) == a.end() && meet(a, b))
          found.insert(sorted(a, b));
  }

  std::set<Features> found;

 private:
  // Closer than the margin at one of some instants?
  [[nodiscard]] bool meet(const std::vector<int>& a, const std::vector<int>& b) const {
    const std::vector<int>& first = a.size() <= b.size() ? a : b;
    const std::vector<int>& second = a.size() <= b.size() ? b : a;
    const Kind kind = first.size() == 1 ? Kind::vertex_triangle : Kind::edge_edge;
    Eigen::Matrix<double, 3, 4> corners;
    for (const double time : {0.0, 0.3, 0.6, 1.0}) {
      Eigen::Index column = 0;
      for (const auto* feature : {&first, &second})
        for (const int v : *feature)
          corners.col(column++) = (1 - time) * t0_.col(v) + time * t1_.col(v);
      if ((corners * closest_weights(kind, corners)).norm() <= margin_m) return true;
    }
    return false;
  }

  const Matrix3Xd& t0_;
  const Matrix3Xd& t1_;
};

// A ribbon of any size, down to 2 x 2, beside a soup of triangles, some without area.
TEST(SweptPairs, are_all_that_come_close_by_brute_force_and_each_once) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::size_t pairs_in_all = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const RibbonGrid grid{2 + trial % 8, 2 + trial % 3};
    const int first = grid.particle_count();
    Eigen::Matrix3Xi soup(3, 4);
    soup << 0, 3, 6, 7, 1, 4, 6, 8, 2, 5, 0, 4;  // the third triangle is an edge
    soup.array() += first;
    Matrix3Xd t0(3, first + 9);
    for (double& value : t0.reshaped()) value = 3 * coordinate(random);
    t0.leftCols(first) = 0.3 * flat_ribbon(grid) + 0.1 * t0.leftCols(first);
    Matrix3Xd t1 = t0;
    for (double& value : t1.leftCols(first).reshaped()) value += 0.1 * trial * coordinate(random);

    Bodies bodies{grid, ObstacleBody(soup.array() - first, t0.rightCols(9))};
    std::set<Features> listed;
    std::vector<FeaturePair> pairs;
    list_pairs_within_ranges(bodies, vertex_ranges(t0.leftCols(first), t1.leftCols(first)),
                             margin_m, pairs);
    for (const FeaturePair& pair : pairs)
      EXPECT_TRUE(listed.insert(features(pair)).second) << "listed twice";

    const Shape ribbon = shape_of(grid.triangles());
    const Shape obstacle = shape_of(soup);
    BruteForce expected(t0, t1);
    expected.look(ribbon.vertices, ribbon.triangles);
    expected.look(ribbon.vertices, obstacle.triangles);
    expected.look(obstacle.vertices, ribbon.triangles);
    expected.look(ribbon.edges, ribbon.edges);
    expected.look(ribbon.edges, obstacle.edges);
    EXPECT_TRUE(
        std::includes(listed.begin(), listed.end(), expected.found.begin(), expected.found.end()))
        << trial;
    pairs_in_all += expected.found.size();
  }
  EXPECT_GT(pairs_in_all, 500U);
}

}  // namespace ribbon::swept_pairs_test
