#include "verification/frame_verifier.h"

#include <cassert>
#include <utility>

namespace ribbon {

namespace {

TriangleSoup joined(const RibbonGrid& grid, const std::optional<TriangleMesh>& obstacle) {
  const int particles = grid.particle_count();
  const Eigen::Matrix3Xi ribbon = grid.triangles();
  const Eigen::Index points = obstacle ? obstacle->vertices.cols() : 0;
  const Eigen::Index triangles = obstacle ? obstacle->triangles.cols() : 0;
  TriangleSoup soup;
  soup.judged = grid.triangle_count();
  soup.points.setZero(3, particles + points);
  soup.triangles.resize(3, ribbon.cols() + triangles);
  soup.triangles.leftCols(ribbon.cols()) = ribbon;
  if (obstacle) {
    soup.points.rightCols(points) = obstacle->vertices;
    soup.triangles.rightCols(triangles) = obstacle->triangles.array() + particles;
  }
  return soup;
}

}  // namespace

FrameVerifier::FrameVerifier(RestSize size, const std::optional<TriangleMesh>& obstacle,
                             const LimitedEdges& limited)
    : size_(std::move(size)),
      limited_(limited),
      soup_(joined(size_.grid, obstacle)),
      owners_(soup_.triangles),
      obstacle_(soup_, soup_.judged, static_cast<int>(soup_.triangles.cols())) {}

TriangleSoup FrameVerifier::soup(const Eigen::Matrix3Xf& positions) const {
  TriangleSoup soup = soup_;
  soup.points.leftCols(size_.grid.particle_count()) = positions;
  return soup;
}

LayerGaps FrameVerifier::layer_gaps(const Eigen::Matrix3Xf& positions) const {
  return {soup(positions), size_, obstacle_};
}

bool FrameVerifier::intersects(const Eigen::Matrix3Xf& positions) const {
  const TriangleSoup frame = soup(positions);
  const BoxTree ribbon(frame, 0, frame.judged);
  return !intersecting_pairs(frame, ribbon, obstacle_, 1).pairs.empty();
}

FrameVerdict FrameVerifier::verify(const Eigen::Matrix3Xf& positions) const {
  assert(positions.cols() == size_.grid.particle_count());
  FrameVerdict verdict;
  verdict.finite = positions.allFinite();
  if (!verdict.finite) return verdict;
  const TriangleSoup frame = soup(positions);
  const BoxTree ribbon(frame, 0, frame.judged);
  verdict.strain = largest_strain(size_, limited_, positions);
  verdict.intersections = intersecting_pairs(frame, ribbon, obstacle_, most_pairs);
  const auto& pairs = verdict.intersections.pairs;
  if (!pairs.empty())
    verdict.gap.pair = pairs.front();
  else if (const auto gap = smallest_gap(frame, owners_, ribbon, obstacle_))
    verdict.gap = *gap;
  return verdict;
}

}  // namespace ribbon
