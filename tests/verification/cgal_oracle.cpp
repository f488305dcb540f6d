#include "verification/cgal_oracle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

namespace ribbon {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Shape = std::variant<Point, Kernel::Segment_3, Kernel::Triangle_3>;
using Vertices = std::vector<int>;

Point point(const TriangleSoup& soup, int vertex) {
  return {soup.points(0, vertex), soup.points(1, vertex), soup.points(2, vertex)};
}

// What one to three vertices span: a segment where they lie on a line, a point where they coincide.
Shape span_of(const TriangleSoup& soup, const Vertices& vertices) {
  std::vector<Point> points;
  for (const int vertex : vertices) points.push_back(point(soup, vertex));
  if (points.size() == 3 && !CGAL::collinear(points[0], points[1], points[2]))
    return Kernel::Triangle_3(points[0], points[1], points[2]);
  const auto [low, high] = std::minmax_element(points.begin(), points.end());
  if (*low == *high) return *low;
  return Kernel::Segment_3(*low, *high);
}

bool meet(const Shape& a, const Shape& b) {
  return std::visit([](const auto& x, const auto& y) { return CGAL::do_intersect(x, y); }, a, b);
}

bool share_a_vertex(const Vertices& a, const Vertices& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](int vertex) { return std::find(b.begin(), b.end(), vertex) != b.end(); });
}

Vertices vertices_of(const TriangleSoup& soup, int triangle) {
  const auto column = soup.triangles.col(triangle);
  return {column[0], column[1], column[2]};
}

Vertices without(Vertices vertices, const Vertices& others) {
  std::erase_if(vertices, [&](int vertex) {
    return std::find(others.begin(), others.end(), vertex) != others.end();
  });
  return vertices;
}

// Corners, edges and the triangle itself.
std::vector<Vertices> features(const Vertices& t) {
  return {{t[0]}, {t[1]}, {t[2]}, {t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}, t};
}

// Two features that share no vertex: whatever one of t is, the other is part of what u has beside
// it.
bool features_meet(const TriangleSoup& soup, const Vertices& t, const Vertices& u) {
  for (const Vertices& feature : features(t)) {
    const Vertices beside = without(u, feature);
    if (!beside.empty() && meet(span_of(soup, feature), span_of(soup, beside))) return true;
  }
  return false;
}

bool triangles_meet_by_cgal(const TriangleSoup& soup, int first, int second) {
  const Vertices t = vertices_of(soup, first);
  const Vertices u = vertices_of(soup, second);
  if (!share_a_vertex(t, u)) return meet(span_of(soup, t), span_of(soup, u));
  return std::is_permutation(t.begin(), t.end(), u.begin()) || features_meet(soup, t, u);
}

using TriangleBox =
    CGAL::Box_intersection_d::Box_with_info_d<double, 3, int,
                                              CGAL::Box_intersection_d::ID_EXPLICIT>;

std::vector<TriangleBox> boxes(const TriangleSoup& soup, int first, int last) {
  std::vector<TriangleBox> result;
  for (int triangle = first; triangle < last; ++triangle) {
    CGAL::Bbox_3 box;
    for (const int vertex : vertices_of(soup, triangle)) box += point(soup, vertex).bbox();
    result.emplace_back(box, triangle);
  }
  return result;
}

using Mesh = CGAL::Surface_mesh<Point>;

Mesh ribbon_mesh(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions) {
  Mesh mesh;
  for (const auto& p : positions.colwise()) mesh.add_vertex(Point(p[0], p[1], p[2]));
  using Vertex = Mesh::Vertex_index;
  const Eigen::Matrix3Xi triangles = grid.triangles();
  for (const auto& t : triangles.colwise()) mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  return mesh;
}

TrianglePair in_order(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

std::vector<TrianglePair> cgal_intersecting_pairs(const TriangleSoup& soup) {
  auto judged = boxes(soup, 0, soup.judged);
  auto rest = boxes(soup, soup.judged, static_cast<int>(soup.triangles.cols()));
  std::vector<TrianglePair> pairs;
  const auto test = [&](const TriangleBox& a, const TriangleBox& b) {
    if (triangles_meet_by_cgal(soup, a.info(), b.info()))
      pairs.push_back(in_order(a.info(), b.info()));
  };
  CGAL::box_self_intersection_d(judged.begin(), judged.end(), test);
  CGAL::box_intersection_d(judged.begin(), judged.end(), rest.begin(), rest.end(), test);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::optional<std::vector<TrianglePair>> cgal_self_intersections(
    const RibbonGrid& grid, const Eigen::Matrix3Xf& positions) {
  const Mesh mesh = ribbon_mesh(grid, positions);
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(found));
  std::vector<TrianglePair> pairs;
  for (const auto& [a, b] : found) {
    if (a == b) return std::nullopt;
    pairs.push_back(in_order(static_cast<int>(a.idx()), static_cast<int>(b.idx())));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace ribbon
