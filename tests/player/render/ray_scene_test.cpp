#include "player/render/ray_scene.h"

#include <gtest/gtest.h>
#include <pmmintrin.h>

#include <array>
#include <limits>

#include "geometry/solids.h"
#include "player/quads.h"

namespace ribbon::ray_scene_test {

Surface flat_ribbon(float z) {
  Eigen::Matrix3Xf positions = test::flat_quad();
  positions.row(2).setConstant(z);
  return test::quad_surface(positions);
}

// The ribbon's quad at z = 0 and a square obstacle of side 2 at z = -1.
struct TwoQuads {
  explicit TwoQuads(float ribbon_z = 0) {
    const Surface ribbon = flat_ribbon(ribbon_z);
    const Surface obstacle =
        creased_surface(quad_mesh({-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}));
    bodies = HitSurface(joined(ribbon, obstacle));
    scene.set_bodies(bodies, 2, RibbonTree::rebuilt);
  }

  HitSurface bodies;
  RayScene scene;
};

Ray down(float x, float y) {
  return {{x, y, 5}, {0, 0, -1}};
}

RayBatch batch_of(std::initializer_list<Ray> rays) {
  RayBatch batch;
  for (const Ray& ray : rays) batch.add(ray);
  return batch;
}

TEST(RayScene, the_nearest_body_is_hit_whichever_it_is) {
  const RayBatch rays = batch_of({down(0, 0), down(0, 0.9F), down(1.9F, 0), down(0, 3)});
  HitBatch hits;
  TwoQuads().scene.first_hits(rays, Coherence::similar, hits);
  EXPECT_EQ(hits.body[0], Body::ribbon);
  EXPECT_EQ(hits.body[1], Body::obstacle);
  EXPECT_EQ(hits.body[2], Body::ribbon);
  EXPECT_EQ(hits.body[3], Body::none);
  TwoQuads(-2).scene.first_hits(rays, Coherence::similar, hits);
  EXPECT_EQ(hits.body[0], Body::obstacle);
}

TEST(RayScene, the_ribbon_is_where_it_was_put_last) {
  for (const RibbonTree tree : {RibbonTree::rebuilt, RibbonTree::refitted}) {
    TwoQuads quads;
    Eigen::Matrix3Xf moved = test::flat_quad();
    moved.row(1).array() += 10;
    quads.bodies.move_to(test::quad_surface(moved));
    quads.scene.set_bodies(quads.bodies, 2, tree);
    const RayBatch rays = batch_of({down(1.9F, 0), down(1.9F, 10), down(0, 0)});
    HitBatch hits;
    quads.scene.first_hits(rays, Coherence::mixed, hits);
    EXPECT_EQ(hits.body[0], Body::none);
    EXPECT_EQ(hits.body[1], Body::ribbon);
    EXPECT_EQ(hits.body[2], Body::obstacle);
  }
}

TEST(RayScene, any_number_of_rays_is_answered_one_by_one) {
  const TwoQuads quads;
  const RayScene& scene = quads.scene;
  for (std::size_t count = 0; count <= 40; ++count) {
    RayBatch rays;
    for (std::size_t i = 0; i < count; ++i) rays.add(down(0, i % 3 == 0 ? 0.0F : 3.0F));
    HitBatch hits;
    Lanes<float> free;
    scene.first_hits(rays, Coherence::similar, hits);
    scene.unblocked(rays, Coherence::mixed, free);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(hits.body[i], i % 3 == 0 ? Body::ribbon : Body::none);
      EXPECT_EQ(free[i], i % 3 == 0 ? 0 : 1);
    }
  }
}

TEST(RayScene, corner_weights_tell_the_place) {
  const RecordingHeader header = test::quad_ribbon();
  const RayBatch rays = batch_of({down(0.7F, -0.1F)});
  HitBatch hits;
  TwoQuads().scene.first_hits(rays, Coherence::similar, hits);
  const Eigen::Vector3i corners = header.grid.triangles().col(hits.triangle[0]);
  const Eigen::Matrix3Xf at = test::flat_quad();
  const Eigen::Vector3f position = (1 - hits.u[0] - hits.v[0]) * at.col(corners[0]) +
                                   hits.u[0] * at.col(corners[1]) + hits.v[0] * at.col(corners[2]);
  EXPECT_NEAR(position.x(), 0.7F, 1e-5);
  EXPECT_NEAR(position.y(), -0.1F, 1e-5);
}

TEST(RayScene, distances_are_in_lengths_of_the_direction) {
  RayBatch rays = batch_of({down(0, 0), down(0, 0), down(40, 0)});
  const Ray once = rays.ray(0);
  rays.direction.set(1, 4 * once.direction);
  HitBatch hits;
  TwoQuads().scene.first_hits(rays, Coherence::similar, hits);
  EXPECT_NEAR((once.origin + hits.distance[0] * once.direction).z(), 0, 1e-5);
  EXPECT_NEAR(hits.distance[1], hits.distance[0] / 4, 1e-5);
  EXPECT_EQ(hits.distance[2], std::numeric_limits<float>::infinity());
}

TEST(RayScene, without_anything_every_ray_is_free) {
  const RayBatch rays = batch_of({down(0, 0)});
  HitBatch hits;
  Lanes<float> free;
  const RayScene scene;
  scene.first_hits(rays, Coherence::similar, hits);
  scene.unblocked(rays, Coherence::similar, free);
  EXPECT_EQ(hits.body[0], Body::none);
  EXPECT_EQ(free[0], 1);
}

TEST(FlushDenormals, the_thread_is_left_as_it_was) {
  const unsigned before = _mm_getcsr();
  {
    const FlushDenormals fast;
    EXPECT_EQ(_MM_GET_FLUSH_ZERO_MODE(), static_cast<unsigned>(_MM_FLUSH_ZERO_ON));
    EXPECT_EQ(_MM_GET_DENORMALS_ZERO_MODE(), static_cast<unsigned>(_MM_DENORMALS_ZERO_ON));
  }
  EXPECT_EQ(_mm_getcsr(), before);
}

}  // namespace ribbon::ray_scene_test
