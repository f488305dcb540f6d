#include "player/render/render_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace ribbon {

namespace {

const Color obstacle_color = from_srgb(0xC9C5BE);

float reach(const Eigen::Matrix3Xf& points) {
  return points.cols() == 0 ? 0.0F : points.cwiseAbs().maxCoeff();
}

// Light that grazes a smooth surface must not be stopped by the flat triangles that stand for it.
// So it starts where the smooth surface would be: on the mean of the corners' tangent planes, where
// they lie above the triangle (after J. Hanika, Hacking the shadow terminator, Ray Tracing Gems
// II).
Eigen::Vector3f lifted(const Eigen::Vector3f& point, const Eigen::Matrix3f& corners,
                       const Eigen::Matrix3f& normals, const Eigen::Vector3f& weights) {
  Eigen::Vector3f result = point;
  for (int i = 0; i < 3; ++i) {
    const float below = normals.col(i).dot(point - corners.col(i));
    if (below < 0) result -= weights[i] * below * normals.col(i);
  }
  return result;
}

}  // namespace

RenderScene::RenderScene(const RecordingHeader& header, bool with_selvages)
    : grid_(header.grid),
      with_selvages_(with_selvages),
      pattern_(header.uv),
      ribbon_width_m_(static_cast<float>(header.ribbon_width_m)),
      ribbon_(ribbon_surface(header.grid)) {
  assert(header.uv.cols() == grid_.particle_count());
  if (with_selvages) add_selvages(grid_, ribbon_);
  pattern_.row(0) *= static_cast<float>(header.ribbon_length_m / header.ribbon_width_m);
  if (!header.obstacle || header.obstacle->triangles.cols() == 0) return;
  obstacle_ = creased_surface(*header.obstacle);
  obstacle_reach_ = reach(obstacle_.vertices);
  rays_.set_obstacle(obstacle_);
}

void RenderScene::set_ribbon(const Eigen::Matrix3Xf& positions,
                             const std::vector<float>& half_thickness_m) {
  assert(positions.cols() == grid_.particle_count());
  update_ribbon(grid_, positions, ribbon_);
  if (with_selvages_) update_selvages(grid_, half_thickness_m, ribbon_);
  rays_.set_ribbon(ribbon_);
  // Some hundred times what single precision loses in a coordinate, and far less than cloth is
  // thick.
  clearance_ = 1e-5F * std::max(obstacle_reach_, reach(positions));
}

void RenderScene::color_ribbon(std::vector<float> places, const ColorMap& map) {
  assert(static_cast<int>(places.size()) == grid_.particle_count());
  places_ = std::move(places);
  map_ = map;
}

Color RenderScene::ribbon_color(const Eigen::Vector3i& corners, const Eigen::Vector3f& weights,
                                bool front, float reach_m) const {
  if (!places_.empty()) {
    float place = 0;
    for (int i = 0; i < 3; ++i) place += weights[i] * places_[particle_of(grid_, corners[i])];
    return map_->at(place);
  }
  Eigen::Vector2f texture = Eigen::Vector2f::Zero();
  for (int i = 0; i < 3; ++i) texture += weights[i] * pattern_.col(particle_of(grid_, corners[i]));
  return cloth_.color(texture.x(), texture.y(), front, reach_m / ribbon_width_m_);
}

bool RenderScene::add_ground(const RayBatch& rays, std::size_t lane, SurfaceBatch& batch) const {
  const Eigen::Vector3f origin = rays.origin.at(lane);
  const Eigen::Vector3f direction = rays.direction.at(lane);
  if (!ground_m_ || direction.y() >= 0 || origin.y() <= *ground_m_) return false;
  const Eigen::Vector3f position = origin + (*ground_m_ - origin.y()) / direction.y() * direction;
  const std::size_t to = batch.count++;
  batch.position.set(to, position);
  batch.normal.set(to, Eigen::Vector3f::UnitY());
  batch.start.set(to, position + clearance_ * Eigen::Vector3f::UnitY());
  batch.body[to] = Hit::Body::ground;
  return true;
}

void RenderScene::add_point(const RayBatch& rays, std::size_t lane, const Hit& hit,
                            SurfaceBatch& batch) const {
  assert(hit.body != Hit::Body::none && batch.count < batch_size);
  const Surface& surface = hit.body == Hit::Body::ribbon ? ribbon_ : obstacle_;
  const Eigen::Vector3i corner = surface.triangles.col(hit.triangle);
  const Eigen::Vector3f weights(1 - hit.u - hit.v, hit.u, hit.v);
  Eigen::Matrix3f corners;
  Eigen::Matrix3f normals;
  for (int i = 0; i < 3; ++i) {
    corners.col(i) = surface.vertices.col(corner[i]);
    normals.col(i) = surface.normals.col(corner[i]);
  }
  Eigen::Vector3f facet = surface.facets.col(hit.triangle);
  const Eigen::Vector3f direction = rays.direction.at(lane);
  const bool front = facet.dot(direction) < 0;
  if (!front) {
    normals = -normals;
    facet = -facet;
  }
  // Where the cloth is folded flat its neighbours' normals cancel or even turn round.
  const Eigen::Vector3f smooth = normals * weights;
  const float length = smooth.norm();
  const Eigen::Vector3f position = corners * weights;
  const float distance = std::sqrt((position - rays.origin.at(lane)).squaredNorm() /
                                   direction.squaredNorm());  // in lengths of its direction
  const std::size_t to = batch.count++;
  batch.position.set(to, position);
  batch.normal.set(to, smooth.dot(facet) > 0.1F * length ? smooth / length : facet);
  batch.start.set(to, lifted(position, corners, normals, weights) + clearance_ * facet);
  // A selvage has neither front nor back.
  const bool shows_front = front || static_cast<int>(hit.triangle) >= grid_.triangle_count();
  const Color albedo = hit.body == Hit::Body::ribbon
                           ? ribbon_color(corner, weights, shows_front, rays.spread * distance)
                           : obstacle_color;
  batch.albedo.set(to, albedo.matrix());
  batch.body[to] = hit.body;
}

}  // namespace ribbon
