#include "player/render/surface_points.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "parallel/vector_loop.h"
#include "player/render/lane_vector.h"

namespace ribbon {

namespace {

// Little enough to stay near the processor.
constexpr std::size_t group_size = 64;
using Row = std::array<float, group_size>;

struct Vectors {
  Row x, y, z;
};

LaneVector vector_of(const std::array<float, 3>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

// What rays met, not yet interpolated.
struct alignas(64) Group {
  struct Corners {
    Vectors position;
    Vectors normal;
    Row texture_x, texture_y;
    Row weight;
  };
  std::array<Corners, 3> corners;
  Vectors facet;
  Vectors origin;
  Vectors direction;
  float spread = 0;  // of the rays, in units of the texture
  std::size_t count = 0;
};

void gather(const std::vector<HitSurface::Corner>& corners,
            const std::vector<HitSurface::Triangle>& triangles, const RayBatch& rays,
            const HitBatch& hits, const std::uint16_t* lanes, Group& group) {
  for (std::size_t i = 0; i < group.count; ++i) {
    const std::size_t lane = lanes[i];
    const HitSurface::Triangle& triangle = triangles[hits.triangle[lane]];
    for (std::size_t c = 0; c < 3; ++c) {
      const HitSurface::Corner& corner = corners[static_cast<std::size_t>(triangle.corners[c])];
      set_lane(group.corners[c].position, i, vector_of(corner.position));
      set_lane(group.corners[c].normal, i, vector_of(corner.normal));
      group.corners[c].texture_x[i] = corner.texture[0];
      group.corners[c].texture_y[i] = corner.texture[1];
    }
    group.corners[1].weight[i] = hits.u[lane];
    group.corners[2].weight[i] = hits.v[lane];
    set_lane(group.facet, i, vector_of(triangle.facet));
    set_lane(group.origin, i, lane_of(rays.origin, lane));
    set_lane(group.direction, i, lane_of(rays.direction, lane));
  }
}

// Where the cloth is folded flat its neighbours' normals cancel or even turn round: there the
// facet's own stands for the smooth surface's.
[[gnu::always_inline]] inline LaneVector unit_normal(LaneVector smooth, LaneVector facet) {
  const float length = std::sqrt(dot(smooth, smooth));
  const bool usable = dot(smooth, facet) > 0.1F * length;
  const float inverse = 1 / (usable ? length : 1.0F);
  return {usable ? inverse * smooth.x : facet.x, usable ? inverse * smooth.y : facet.y,
          usable ? inverse * smooth.z : facet.z};
}

// Light that grazes a smooth surface must not be stopped by the flat triangles that stand for it.
// So it starts where the smooth surface would be: on the mean of the corners' tangent planes, where
// they lie above the triangle (after J. Hanika, Hacking the shadow terminator, Ray Tracing Gems
// II). This is what one corner, of that weight, lifts it by.
[[gnu::always_inline]] inline LaneVector lift(LaneVector position, LaneVector corner,
                                              LaneVector normal, float weight) {
  const float above = dot(normal, position - corner);
  return (above < 0 ? -weight * above : 0.0F) * normal;
}

void interpolate(const Group& group, float clearance_m, std::size_t to, SurfaceBatch& batch,
                 std::size_t look, LookBatch& looks) {
  const Group::Corners& a = group.corners[0];
  const Group::Corners& b = group.corners[1];
  const Group::Corners& c = group.corners[2];
  vectorised([&]() RIBBON_INLINED {
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < group.count; ++i) {
      const float wb = b.weight[i];
      const float wc = c.weight[i];
      const float wa = 1 - wb - wc;
      const auto mean = [&](LaneVector at_a, LaneVector at_b, LaneVector at_c)
                            RIBBON_INLINED { return wa * at_a + wb * at_b + wc * at_c; };
      const LaneVector towards = lane_of(group.direction, i);
      const LaneVector outer = lane_of(group.facet, i);
      const float side = dot(outer, towards) < 0 ? 1.0F : -1.0F;
      const LaneVector facet = side * outer;
      const LaneVector normal_a = side * lane_of(a.normal, i);
      const LaneVector normal_b = side * lane_of(b.normal, i);
      const LaneVector normal_c = side * lane_of(c.normal, i);
      const LaneVector corner_a = lane_of(a.position, i);
      const LaneVector corner_b = lane_of(b.position, i);
      const LaneVector corner_c = lane_of(c.position, i);
      const LaneVector position = mean(corner_a, corner_b, corner_c);
      const LaneVector lifted = position + lift(position, corner_a, normal_a, wa) +
                                lift(position, corner_b, normal_b, wb) +
                                lift(position, corner_c, normal_c, wc) + clearance_m * facet;
      const LaneVector way = position - lane_of(group.origin, i);
      set_lane(batch.position, to + i, position);
      set_lane(batch.start, to + i, lifted);
      set_lane(batch.normal, to + i, unit_normal(mean(normal_a, normal_b, normal_c), facet));
      looks.x[look + i] = wa * a.texture_x[i] + wb * b.texture_x[i] + wc * c.texture_x[i];
      looks.y[look + i] = wa * a.texture_y[i] + wb * b.texture_y[i] + wc * c.texture_y[i];
      looks.front[look + i] = side < 0 ? 0.0F : 1.0F;
      looks.reach[look + i] = group.spread * std::sqrt(dot(way, way) / dot(towards, towards));
    }
  });
}

}  // namespace

HitSurface::HitSurface(const Surface& surface, float unit_m)
    : unit_m_(unit_m),
      corners_(static_cast<std::size_t>(surface.vertices.cols())),
      triangles_(static_cast<std::size_t>(surface.triangles.cols())) {
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    Eigen::Map<Eigen::Vector3i>(triangles_[t].corners.data()) =
        surface.triangles.col(static_cast<Eigen::Index>(t));
  move_to(surface);
}

void HitSurface::move_to(const Surface& surface) {
  assert(corners_.size() == static_cast<std::size_t>(surface.vertices.cols()));
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const auto column = static_cast<Eigen::Index>(c);
    Eigen::Map<Eigen::Vector3f>(corners_[c].position.data()) = surface.vertices.col(column);
    Eigen::Map<Eigen::Vector3f>(corners_[c].normal.data()) = surface.normals.col(column);
  }
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    Eigen::Map<Eigen::Vector3f>(triangles_[t].facet.data()) =
        surface.facets.col(static_cast<Eigen::Index>(t));
}

void HitSurface::find_points(const RayBatch& rays, const HitBatch& hits, const LaneList& list,
                             float clearance_m, SurfaceBatch& batch, LookBatch& looks) const {
  assert(batch.count + list.count <= batch_size);
  Group group;
  group.spread = rays.spread / unit_m_;
  for (std::size_t first = 0; first < list.count; first += group_size) {
    group.count = std::min(group_size, list.count - first);
    gather(corners_, triangles_, rays, hits, list.lanes.data() + first, group);
    interpolate(group, clearance_m, batch.count + first, batch, first, looks);
  }
}

}  // namespace ribbon
