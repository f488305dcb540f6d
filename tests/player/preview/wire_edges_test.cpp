#include "player/preview/wire_edges.h"

#include <gtest/gtest.h>

namespace ribbon::wire_edges_test {

// Corner k of the unit cube is at the bits of k.
TriangleMesh cube() {
  TriangleMesh mesh{"cube", Eigen::Matrix3Xf(3, 8), Eigen::Matrix3Xi(3, 12)};
  for (int k = 0; k < 8; ++k)
    mesh.vertices.col(k) = Eigen::Vector3i(k & 1, k >> 1 & 1, k >> 2).cast<float>();
  mesh.triangles << 0, 0, 4, 4, 0, 0, 2, 2, 0, 0, 1, 1,  //
      2, 3, 5, 7, 1, 5, 6, 7, 4, 6, 3, 7,                //
      3, 1, 7, 6, 5, 4, 7, 3, 6, 2, 7, 5;
  return mesh;
}

TEST(WireEdges, a_cube_has_twelve_and_no_diagonals) {
  const auto edges = wire_edges(cube());
  EXPECT_EQ(edges.size(), 12U);
  for (const WireEdge& edge : edges) {
    EXPECT_FLOAT_EQ((edge.end - edge.begin).norm(), 1);
    EXPECT_NEAR(edge.face.dot(edge.other_face), 0, 1e-6F) << "faces look to different sides";
    const Eigen::Vector3f outward = (edge.begin + edge.end) / 2 - Eigen::Vector3f::Constant(0.5F);
    EXPECT_GT(edge.face.dot(outward), 0);
    EXPECT_GT(edge.other_face.dot(outward), 0);
  }
}

TEST(WireEdges, vertices_in_the_same_place_count_as_one) {
  const TriangleMesh shared = cube();
  TriangleMesh apart{"cube", Eigen::Matrix3Xf(3, 36), Eigen::Matrix3Xi(3, 12)};
  for (int corner = 0; corner < 36; ++corner) {
    apart.vertices.col(corner) = shared.vertices.col(shared.triangles(corner % 3, corner / 3));
    apart.triangles(corner % 3, corner / 3) = corner;
  }
  EXPECT_EQ(wire_edges(apart).size(), 12U);
}

TEST(WireEdges, a_border_looks_to_both_sides) {
  TriangleMesh triangle{"triangle", Eigen::Matrix3Xf::Identity(3, 3),
                        Eigen::Matrix3Xi{{0}, {1}, {2}}};
  const auto edges = wire_edges(triangle);
  ASSERT_EQ(edges.size(), 3U);
  for (const WireEdge& edge : edges) EXPECT_EQ(edge.face, -edge.other_face);
}

TEST(WireEdges, a_triangle_without_an_area_does_no_harm) {
  TriangleMesh mesh{"points", Eigen::Matrix3Xf::Zero(3, 3), Eigen::Matrix3Xi{{0}, {1}, {2}}};
  EXPECT_TRUE(wire_edges(mesh).empty());
}

}  // namespace ribbon::wire_edges_test
