#include "verification/triangles_meet.h"

#include <array>

#include "exact/orientation.h"

namespace ribbon {

namespace {

using Point = Eigen::Vector3f;
using FlatPoint = Eigen::Vector2f;

FlatPoint without_axis(const Point& point, int axis) {
  return {point[(axis + 1) % 3], point[(axis + 2) % 3]};
}

bool boxes_meet(const FlatPoint& low, const FlatPoint& high, const FlatPoint& other_low,
                const FlatPoint& other_high) {
  return (low.array() <= other_high.array()).all() && (other_low.array() <= high.array()).all();
}

// In the plane. Each straddles the other's line, and their boxes meet: the boxes decide where all
// four points lie on one line or a segment is a point.
bool flat_segments_meet(const FlatPoint& p, const FlatPoint& q, const FlatPoint& a,
                        const FlatPoint& b) {
  return boxes_meet(p.cwiseMin(q), p.cwiseMax(q), a.cwiseMin(b), a.cwiseMax(b)) &&
         turn(a, b, p) * turn(a, b, q) <= 0 && turn(p, q, a) * turn(p, q, b) <= 0;
}

// In the plane. The point does not see edges turn both ways; the box decides where the triangle is
// a segment or a point.
bool flat_triangle_holds(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c,
                         const FlatPoint& p) {
  if (!boxes_meet(p, p, a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c))) return false;
  const std::array turns{turn(a, b, p), turn(b, c, p), turn(c, a, p)};
  const bool left = turns[0] > 0 || turns[1] > 0 || turns[2] > 0;
  const bool right = turns[0] < 0 || turns[1] < 0 || turns[2] < 0;
  return !(left && right);
}

// For points of one plane. Leaving out at least one of the three coordinates shows the plane
// faithfully, and what meets in space meets in all three pictures: so shapes in one plane meet
// exactly when they do in all three.
bool coplanar_segments_meet(const Point& p, const Point& q, const Point& a, const Point& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (!flat_segments_meet(without_axis(p, axis), without_axis(q, axis), without_axis(a, axis),
                            without_axis(b, axis)))
      return false;
  return true;
}

bool coplanar_triangle_holds(const Point& a, const Point& b, const Point& c, const Point& p) {
  for (int axis = 0; axis < 3; ++axis)
    if (!flat_triangle_holds(without_axis(a, axis), without_axis(b, axis), without_axis(c, axis),
                             without_axis(p, axis)))
      return false;
  return true;
}

bool segments_meet(const Point& p, const Point& q, const Point& a, const Point& b) {
  return side_of_plane(p, q, a, b) == 0 && coplanar_segments_meet(p, q, a, b);
}

// p and q lie in a plane of the triangle, which may be degenerate and then lies in many: the
// segment begins inside or it meets the border.
bool segment_meets_flat_on(const Point& p, const Point& q, const Point& a, const Point& b,
                           const Point& c) {
  return coplanar_triangle_holds(a, b, c, p) || segments_meet(p, q, a, b) ||
         segments_meet(p, q, b, c) || segments_meet(p, q, c, a);
}

// p_side, q_side: on which sides of plane abc p and q lie.
bool sided_segment_meets(const Point& p, const Point& q, int p_side, int q_side, const Point& a,
                         const Point& b, const Point& c) {
  if (p_side * q_side > 0) return false;
  if (p_side == 0 && q_side == 0) return segment_meets_flat_on(p, q, a, b, c);
  // The line pq crosses the plane in one point of the segment. It is in the triangle where the
  // line passes all three edges on the same side.
  const int ab = side_of_plane(p, q, a, b);
  const int bc = side_of_plane(p, q, b, c);
  if (ab * bc < 0) return false;
  const int ca = side_of_plane(p, q, c, a);
  return ab * ca >= 0 && bc * ca >= 0;
}

using Corners = std::array<Point, 3>;

std::array<int, 3> sides(const Corners& triangle, const Corners& points) {
  return {side_of_plane(triangle[0], triangle[1], triangle[2], points[0]),
          side_of_plane(triangle[0], triangle[1], triangle[2], points[1]),
          side_of_plane(triangle[0], triangle[1], triangle[2], points[2])};
}

bool all_on_one_side(const std::array<int, 3>& sides) {
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

bool an_edge_meets(const Corners& edges, const std::array<int, 3>& sides, const Corners& triangle) {
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if (sided_segment_meets(edges[k], edges[next], sides[k], sides[next], triangle[0], triangle[1],
                            triangle[2]))
      return true;
  }
  return false;
}

// What two triangles have in common is convex and ends on an edge of one of them.
bool strangers_meet(const Corners& t, const Corners& u) {
  const auto u_sides = sides(t, u);
  if (all_on_one_side(u_sides)) return false;
  const auto t_sides = sides(u, t);
  if (all_on_one_side(t_sides)) return false;
  return an_edge_meets(u, u_sides, t) || an_edge_meets(t, t_sides, u);
}

bool segment_meets(const Point& p, const Point& q, const Corners& t) {
  return segment_meets_triangle(p, q, t[0], t[1], t[2]);
}

// Triangles t and u with t[0] = u[0]. What they have in common beyond that corner reaches, seen
// from it, the opposite edge of the one that ends first.
bool corner_neighbours_meet(const Corners& t, const Corners& u) {
  return segment_meets(t[1], t[2], u) || segment_meets(u[1], u[2], t);
}

// Triangles t and u with t[0] = u[0] and t[1] = u[1].
bool edge_neighbours_meet(const Corners& t, const Corners& u) {
  if (side_of_plane(t[0], t[1], t[2], u[2]) != 0) return false;
  return coplanar_triangle_holds(u[0], u[1], u[2], t[2]) ||
         coplanar_triangle_holds(t[0], t[1], t[2], u[2]) ||
         coplanar_segments_meet(t[0], t[2], u[1], u[2]) ||
         coplanar_segments_meet(t[1], t[2], u[0], u[2]);
}

// The vertices of both triangles in an order that puts common ones first.
struct CommonVertices {
  int count = 0;
  Eigen::Vector3i t;
  Eigen::Vector3i u;
};

CommonVertices common_vertices(const TriangleSoup& soup, const TrianglePair& pair) {
  CommonVertices common{0, soup.triangles.col(pair.first), soup.triangles.col(pair.second)};
  for (int i = 0; i < 3; ++i)
    for (int j = common.count; j < 3; ++j)
      if (common.t[i] == common.u[j]) {
        std::swap(common.t[i], common.t[common.count]);
        std::swap(common.u[j], common.u[common.count]);
        ++common.count;
        break;
      }
  return common;
}

Corners corners(const TriangleSoup& soup, const Eigen::Vector3i& vertices) {
  return {soup.points.col(vertices[0]), soup.points.col(vertices[1]), soup.points.col(vertices[2])};
}

}  // namespace

bool segment_meets_triangle(const Point& p, const Point& q, const Point& a, const Point& b,
                            const Point& c) {
  return sided_segment_meets(p, q, side_of_plane(a, b, c, p), side_of_plane(a, b, c, q), a, b, c);
}

bool triangles_meet(const TriangleSoup& soup, const TrianglePair& pair) {
  const CommonVertices common = common_vertices(soup, pair);
  const Corners t = corners(soup, common.t);
  const Corners u = corners(soup, common.u);
  switch (common.count) {
    case 0:
      return strangers_meet(t, u);
    case 1:
      return corner_neighbours_meet(t, u);
    case 2:
      return edge_neighbours_meet(t, u);
    default:
      return true;
  }
}

}  // namespace ribbon
