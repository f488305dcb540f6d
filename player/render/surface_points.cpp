#include "player/render/surface_points.h"

#include <xmmintrin.h>

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

// Numbers are copied four at a time, of four lanes at a time.
constexpr std::size_t four = 4;
static_assert(group_size % register_lanes == 0 && register_lanes % four == 0);

// What the listed rays met, side by side.
struct alignas(64) Met {
  Lanes<std::uint32_t> triangle;
  Lanes<float> weight_b;  // of the second corner
  Lanes<float> weight_c;  // and of the third
  Lanes<float> distance;
  VectorLanes direction;

  Met(const RayBatch& rays, const HitBatch& hits, const MarkedLanes& list) {
    move_together(hits.triangle, list, triangle.data());
    move_together(hits.u, list, weight_b.data());
    move_together(hits.v, list, weight_c.data());
    move_together(hits.distance, list, distance.data());
    move_together(rays.direction, list, direction);
  }
};

// The corners of a group of them.
struct alignas(64) Group {
  // As they lie in a corner: its position, its normal, its place in the texture.
  using Corner = std::array<Row, 2 * four>;
  std::array<Corner, 3> corners;
  std::size_t first = 0;
  std::size_t count = 0;
};

[[gnu::always_inline]] inline LaneVector vector_of(const Row* rows, std::size_t lane) {
  return {rows[0][lane], rows[1][lane], rows[2][lane]};
}

// Number n of from[l] goes to lane first + l of rows[n].
void lay_side_by_side(const std::array<const float*, four>& from, Row* rows, std::size_t first) {
  __m128 a = _mm_loadu_ps(from[0]);
  __m128 b = _mm_loadu_ps(from[1]);
  __m128 c = _mm_loadu_ps(from[2]);
  __m128 d = _mm_loadu_ps(from[3]);
  _MM_TRANSPOSE4_PS(a, b, c, d);
  _mm_store_ps(rows[0].data() + first, a);
  _mm_store_ps(rows[1].data() + first, b);
  _mm_store_ps(rows[2].data() + first, c);
  _mm_store_ps(rows[3].data() + first, d);
}

void gather_four(const HitSurface::Corner* corners,
                 const std::array<const HitSurface::Corners*, four>& met, std::size_t first,
                 Group& group) {
  std::array<const float*, four> from{};
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t l = 0; l < four; ++l) from[l] = corners[(*met[l])[c]].numbers.data();
    Row* const rows = group.corners[c].data();
    lay_side_by_side(from, rows, first);
    for (const float*& numbers : from) numbers += four;
    lay_side_by_side(from, rows + four, first);
  }
}

// Lanes beyond the last repeat it.
void gather(const HitSurface::Corner* corners, const HitSurface::Corners* triangles, const Met& met,
            Group& group) {
  const std::uint32_t* const triangle = &met.triangle[group.first];
  const std::size_t last = group.count - 1;
  for (std::size_t first = 0; first <= last; first += four) {
    std::array<const HitSurface::Corners*, four> of{};
    for (std::size_t l = 0; l < four; ++l) of[l] = &triangles[triangle[std::min(first + l, last)]];
    gather_four(corners, of, first, group);
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

// spread: of the rays, in units of the texture.
void interpolate(const Met& met, const Group& group, float clearance_m, float spread,
                 SurfaceBatch& batch, LookBatch& looks) {
  const std::size_t look = group.first;
  const std::size_t to = batch.count + group.first;
  const Group::Corner& a = group.corners[0];
  const Group::Corner& b = group.corners[1];
  const Group::Corner& c = group.corners[2];
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(group.count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      const float wb = met.weight_b[look + i];
      const float wc = met.weight_c[look + i];
      const float wa = 1 - wb - wc;
      const auto mean = [&](LaneVector at_a, LaneVector at_b, LaneVector at_c)
                            RIBBON_INLINED { return wa * at_a + wb * at_b + wc * at_c; };
      const LaneVector corner_a = vector_of(a.data(), i);
      const LaneVector corner_b = vector_of(b.data(), i);
      const LaneVector corner_c = vector_of(c.data(), i);
      const LaneVector outer = unit_or_zero(cross(corner_b - corner_a, corner_c - corner_a));
      const float side = dot(outer, lane_of(met.direction, look + i)) < 0 ? 1.0F : -1.0F;
      const LaneVector facet = side * outer;
      const LaneVector normal_a = side * vector_of(&a[3], i);
      const LaneVector normal_b = side * vector_of(&b[3], i);
      const LaneVector normal_c = side * vector_of(&c[3], i);
      const LaneVector position = mean(corner_a, corner_b, corner_c);
      const LaneVector lifted = position + lift(position, corner_a, normal_a, wa) +
                                lift(position, corner_b, normal_b, wb) +
                                lift(position, corner_c, normal_c, wc) + clearance_m * facet;
      set_lane(batch.position, to + i, position);
      set_lane(batch.start, to + i, lifted);
      set_lane(batch.normal, to + i, unit_normal(mean(normal_a, normal_b, normal_c), facet));
      looks.x[look + i] = wa * a[6][i] + wb * b[6][i] + wc * c[6][i];
      looks.y[look + i] = wa * a[7][i] + wb * b[7][i] + wc * c[7][i];
      looks.front[look + i] = side < 0 ? 0.0F : 1.0F;
      looks.reach[look + i] = spread * met.distance[look + i];
    }
  });
}

}  // namespace

HitSurface::HitSurface(const Surface& surface, float unit_m)
    : unit_m_(unit_m),
      corners_(static_cast<std::size_t>(surface.vertices.cols())),
      triangles_(static_cast<std::size_t>(surface.triangles.cols())) {
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    Eigen::Map<Eigen::Vector3i>(triangles_[t].data()) =
        surface.triangles.col(static_cast<Eigen::Index>(t));
  move_to(surface);
}

void HitSurface::move_to(const Surface& surface) {
  const auto count = static_cast<std::size_t>(surface.vertices.cols());
  assert(count <= corners_.size());
  for (std::size_t c = 0; c < count; ++c) {
    const auto column = static_cast<Eigen::Index>(c);
    Eigen::Map<Eigen::Vector3f>(corners_[c].position()) = surface.vertices.col(column);
    Eigen::Map<Eigen::Vector3f>(corners_[c].normal()) = surface.normals.col(column);
  }
}

void HitSurface::find_points(const RayBatch& rays, const HitBatch& hits, const MarkedLanes& list,
                             float clearance_m, SurfaceBatch& batch, LookBatch& looks) const {
  assert(batch.count + list.count <= batch_size);
  const Met met(rays, hits, list);
  Group group;
  for (; group.first < list.count; group.first += group_size) {
    group.count = std::min(group_size, list.count - group.first);
    gather(corners_.data(), triangles_.data(), met, group);
    interpolate(met, group, clearance_m, rays.spread / unit_m_, batch, looks);
  }
}

}  // namespace ribbon
