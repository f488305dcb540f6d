#include "player/render/render_scene.h"

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace ribbon {

namespace {

const Color obstacle_color = from_srgb(0xC9C5BE);

float reach(const Eigen::Matrix3Xf& points) {
  return points.cols() == 0 ? 0.0F : points.cwiseAbs().maxCoeff();
}

void fill(VectorLanes& lanes, std::size_t first, std::size_t count, const Color& color) {
  const auto from = static_cast<std::ptrdiff_t>(first);
  std::fill_n(lanes.x.begin() + from, count, color[0]);
  std::fill_n(lanes.y.begin() + from, count, color[1]);
  std::fill_n(lanes.z.begin() + from, count, color[2]);
}

}  // namespace

RenderScene::RenderScene(const RecordingHeader& header, bool with_selvages)
    : grid_(header.grid), with_selvages_(with_selvages), ribbon_(ribbon_surface(header.grid)) {
  assert(header.uv.cols() == grid_.particle_count());
  if (with_selvages) add_selvages(grid_, ribbon_);
  if (header.obstacle && header.obstacle->triangles.cols() > 0)
    obstacle_ = creased_surface(*header.obstacle);
  obstacle_reach_ = reach(obstacle_.vertices);
  bodies_ = HitSurface(joined(ribbon_, obstacle_), static_cast<float>(header.ribbon_width_m));
  const auto length = static_cast<float>(header.ribbon_length_m / header.ribbon_width_m);
  for (int vertex = 0; vertex < ribbon_.vertices.cols(); ++vertex) {
    const Eigen::Vector2f uv = header.uv.col(particle_of(grid_, vertex));
    bodies_.corners()[static_cast<std::size_t>(vertex)].set_texture(uv.x() * length, uv.y());
  }
}

void RenderScene::set_ribbon(const Eigen::Matrix3Xf& positions,
                             const std::vector<float>& half_thickness_m, RibbonTree tree) {
  assert(positions.cols() == grid_.particle_count());
  update_ribbon(grid_, positions, ribbon_);
  if (with_selvages_) update_selvages(grid_, half_thickness_m, ribbon_);
  bodies_.move_to(ribbon_);
  rays_.set_bodies(bodies_, static_cast<std::uint32_t>(ribbon_.triangles.cols()), tree);
  // Some hundred times what single precision loses in a coordinate, and far less than cloth is
  // thick.
  clearance_ = 1e-5F * std::max(obstacle_reach_, reach(positions));
}

void RenderScene::color_ribbon(const std::vector<float>& places, const ColorMap& map) {
  assert(static_cast<int>(places.size()) == grid_.particle_count());
  for (int vertex = 0; vertex < ribbon_.vertices.cols(); ++vertex)
    bodies_.corners()[static_cast<std::size_t>(vertex)].set_texture(
        places[static_cast<std::size_t>(particle_of(grid_, vertex))], 0);
  map_ = map;
}

void RenderScene::set_ribbon_colors(const HitBatch& hits, const MarkedLanes& list, LookBatch& looks,
                                    SurfaceBatch& batch) const {
  if (map_) {
    for (std::size_t i = 0; i < list.count; ++i)
      batch.albedo.set(batch.count + i, map_->at(looks.x[i]).matrix());
    return;
  }
  // A selvage has neither front nor back.
  const auto cloth_triangles = static_cast<std::uint32_t>(grid_.triangle_count());
  if (with_selvages_)
    for (std::size_t i = 0; i < list.count; ++i)
      if (hits.triangle[list.lanes[i]] >= cloth_triangles) looks.front[i] = 1;
  cloth_.find_colors(looks, list.count, batch.albedo, batch.count);
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
  batch.body[to] = Body::ground;
  return true;
}

void RenderScene::add_points(Body body, const RayBatch& rays, const HitBatch& hits,
                             const MarkedLanes& list, SurfaceBatch& batch) const {
  if (list.count == 0) return;
  LookBatch looks;
  bodies_.find_points(rays, hits, list, clearance_, batch, looks);
  if (body == Body::ribbon)
    set_ribbon_colors(hits, list, looks, batch);
  else
    fill(batch.albedo, batch.count, list.count, obstacle_color);
  std::fill_n(batch.body.begin() + static_cast<std::ptrdiff_t>(batch.count), list.count, body);
  batch.count += list.count;
}

}  // namespace ribbon
