#include "knot/motion/selvage_linking.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

#include "geometry/vectors.h"
#include "knot/type/view_crossing.h"

namespace ribbon {
namespace {

using Directions = SelvageLinking::Directions;

// The first is close to +z, so that it shows the drawing; the others serve where that is not in
// general position. Third coordinate 1.
const std::array<Eigen::Vector3d, 4>& views() {
  static const std::array<Eigen::Vector3d, 4> result{
      {{0.036, -0.052, 1}, {-0.041, 0.077, 1}, {0.31, 0.17, 1}, {-0.23, -0.44, 1}}};
  return result;
}

struct Edge {
  ProjectivePoint from, to;
  Eigen::Vector2d low, high;  // its bounding box as seen
};

// Where a point is seen, up to rounding.
Eigen::Vector2d seen_at(const Eigen::Vector3d& point, const Eigen::Vector3d& view) {
  return point.head<2>() - view.head<2>() * point.z();
}

Edge ray_edge(const ProjectivePoint& from, const ProjectivePoint& to) {
  const auto all = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  return {from, to, -all, all};
}

std::vector<Edge> edges_of(const Eigen::Matrix3Xd& curve, const Directions& rays,
                           const Eigen::Vector3d& view) {
  constexpr double rounding = 1e-12;  // far more than seen_at() loses
  const double slack = rounding * curve.cwiseAbs().maxCoeff();
  std::vector<Edge> result{
      ray_edge(ProjectivePoint::direction(rays[0]), ProjectivePoint::point(curve.col(0)))};
  for (Eigen::Index k = 0; k + 1 < curve.cols(); ++k) {
    const Eigen::Vector2d p = seen_at(curve.col(k), view);
    const Eigen::Vector2d q = seen_at(curve.col(k + 1), view);
    result.push_back({ProjectivePoint::point(curve.col(k)),
                      ProjectivePoint::point(curve.col(k + 1)), p.cwiseMin(q).array() - slack,
                      p.cwiseMax(q).array() + slack});
  }
  result.push_back(ray_edge(ProjectivePoint::point(curve.col(curve.cols() - 1)),
                            ProjectivePoint::direction(rays[1])));
  return result;
}

bool seen_apart(const Edge& a, const Edge& b) {
  return a.high.x() < b.low.x() || b.high.x() < a.low.x() || a.high.y() < b.low.y() ||
         b.high.y() < a.low.y();
}

// Are these the two rays of one end?
bool parallel_rays(const Edge& a, const Edge& b) {
  return (a.from.is_direction && b.from.is_direction) || (a.to.is_direction && b.to.is_direction);
}

// The sum of the signs of all crossings of one selvage with the other. Nothing when this view is
// not in general position.
std::optional<int> crossing_sum(const RibbonCurves& curves, const Directions& rays,
                                const Eigen::Vector3d& view) {
  const std::vector<Edge> first = edges_of(curves.first_selvage, rays, view);
  const std::vector<Edge> second = edges_of(curves.second_selvage, rays, view);
  int result = 0;
  for (const Edge& a : first) {
    for (const Edge& b : second) {
      if (seen_apart(a, b) || parallel_rays(a, b)) continue;
      const ViewCrossing pair =
          view_crossing(a.from, a.to, b.from, b.to, ProjectivePoint::direction(view));
      if (pair.seen == ViewOfEdges::doubtful) return {};
      result += pair.sign;
    }
  }
  return result;
}

Eigen::Index tip_index(const Eigen::Matrix3Xd& curve, std::size_t end) {
  return end == 0 ? 0 : curve.cols() - 1;
}

Eigen::Vector3d across(const RibbonCurves& curves, std::size_t end) {
  return curves.second_selvage.col(tip_index(curves.second_selvage, end)) -
         curves.first_selvage.col(tip_index(curves.first_selvage, end));
}

// On which side of the first selvage's ray is the second's, as seen?
int side_seen(const RibbonCurves& curves, std::size_t end, const ProjectivePoint& ray,
              const ProjectivePoint& view) {
  return orientation(
      ProjectivePoint::point(curves.first_selvage.col(tip_index(curves.first_selvage, end))),
      ProjectivePoint::point(curves.second_selvage.col(tip_index(curves.second_selvage, end))),
      view, ray);
}

// How often an end shows its edge to the viewer while it turns the shorter way, right-handed about
// its ray: -1, 0 or 1. Nothing when it does so at the beginning or at the end.
std::optional<int> edge_on_passages(const RibbonCurves& before, const RibbonCurves& now,
                                    std::size_t end, const ProjectivePoint& ray,
                                    const ProjectivePoint& view) {
  const int side_before = side_seen(before, end, ray, view);
  const int side_now = side_seen(now, end, ray, view);
  if (side_before == side_now && side_now != 0) return 0;
  const int sense = orientation(ProjectivePoint::point(Eigen::Vector3d::Zero()),
                                ProjectivePoint::point(across(before, end)),
                                ProjectivePoint::point(across(now, end)), ray);
  if (side_before * side_now * sense == 0) return {};
  return sense;
}

// Has an end turned about its ray by more than a quarter of a turn?
bool is_wide_turn(const RibbonCurves& before, const RibbonCurves& now, std::size_t end,
                  const Eigen::Vector3d& ray) {
  const Eigen::Vector3d from = across(before, end).cross(ray);
  const Eigen::Vector3d to = across(now, end).cross(ray);
  return dot(from, to) < 0;
}

// Has a corner of an end gone farther than the end is wide? So fast it may have turned any way,
// also a whole turn.
bool goes_far(const RibbonCurves& before, const RibbonCurves& now, std::size_t end) {
  const auto way_m = [end](const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
    return length_of(to.col(tip_index(to, end)) - from.col(tip_index(from, end)));
  };
  return std::max(way_m(before.first_selvage, now.first_selvage),
                  way_m(before.second_selvage, now.second_selvage)) >
         length_of(across(before, end));
}

int half_rounded_up(int number) {
  return number / 2 + (number > 0 ? number % 2 : 0);
}

}  // namespace

void SelvageLinking::start(const RibbonCurves& curves, const Directions& rays) {
  for (std::size_t view = 0; view < views().size() && !seen_; ++view)
    if (const auto crossings = crossing_sum(curves, rays, views()[view]))
      seen_ = {view, rays, *crossings};
  if (seen_) number_ = half_rounded_up(seen_->crossing_sum);
}

std::optional<int> SelvageLinking::crossing_sum_before(const RibbonCurves& before,
                                                       const Directions& rays,
                                                       std::size_t view) const {
  if (seen_->view == view && seen_->rays == rays) return seen_->crossing_sum;
  return crossing_sum(before, rays, views()[view]);
}

void SelvageLinking::follow(const RibbonCurves& before, const RibbonCurves& now,
                            const Directions& rays) {
  if (!number_) return;
  for (const std::size_t end : {0U, 1U})
    if (is_wide_turn(before, now, end, rays[end]) || goes_far(before, now, end)) ++wide_turns_;
  for (std::size_t view = 0; view < views().size(); ++view) {
    const ProjectivePoint viewer = ProjectivePoint::direction(views()[view]);
    const auto sum_before = crossing_sum_before(before, rays, view);
    const auto sum_now = crossing_sum(now, rays, views()[view]);
    const auto turned_0 =
        edge_on_passages(before, now, 0, ProjectivePoint::direction(rays[0]), viewer);
    const auto turned_1 =
        edge_on_passages(before, now, 1, ProjectivePoint::direction(rays[1]), viewer);
    if (!sum_before || !sum_now || !turned_0 || !turned_1) continue;
    // Turning an end right-handed about its ray winds a crossing into the ribbon, and one half
    // twist of the far band back.
    const int change = *sum_now - *sum_before - *turned_0 - *turned_1;
    assert(change % 2 == 0);
    *number_ += change / 2;
    seen_ = {view, rays, *sum_now};
    return;
  }
  number_.reset();
}

}  // namespace ribbon
