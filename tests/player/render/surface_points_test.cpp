#include "player/render/surface_points.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <random>

#include "parallel/instruction_set.h"
#include "player/render/cloth_pattern.h"

namespace ribbon::surface_points_test {

constexpr float clearance_m = 1e-5F;
constexpr int triangle_count = 20;

Surface random_surface(std::mt19937& random) {
  std::uniform_real_distribution<float> number(-1, 1);
  const auto any = [&]() {
    return Eigen::Vector3f(number(random), number(random), number(random));
  };
  Surface surface;
  surface.vertices.resize(3, Eigen::Index{3} * triangle_count);
  surface.normals.resize(3, Eigen::Index{3} * triangle_count);
  surface.triangles.resize(3, triangle_count);
  for (int t = 0; t < triangle_count; ++t) {
    surface.triangles.col(t) << 3 * t, 3 * t + 1, 3 * t + 2;
    for (const int vertex : surface.triangles.col(t)) {
      surface.vertices.col(vertex) = any();
      surface.normals.col(vertex) = any().normalized();
    }
  }
  return surface;
}

struct Scene {
  RayBatch rays;
  HitBatch hits;
  MarkedLanes list;
  Surface surface;
  HitSurface hit_surface;
};

// Every third ray has met one of the triangles: no multiple of four.
std::unique_ptr<Scene> random_scene() {
  std::mt19937 random(7);
  auto scene = std::make_unique<Scene>();
  scene->surface = random_surface(random);
  scene->hit_surface = HitSurface(scene->surface, 0.5F);
  std::uniform_real_distribution<float> number(-1, 1);
  std::uniform_real_distribution<float> weight(0, 0.5F);
  for (auto& corner : scene->hit_surface.corners()) {
    const float x = number(random);
    corner.set_texture(x, number(random));
  }
  scene->rays.spread = 0.01F;
  Lanes<Body> bodies;
  for (std::size_t lane = 0; lane < batch_size; ++lane) {
    scene->rays.add({{number(random), number(random), 5}, {number(random), number(random), -1}});
    scene->hits.triangle[lane] = static_cast<std::uint32_t>(random() % triangle_count);
    scene->hits.u[lane] = weight(random);
    scene->hits.v[lane] = weight(random);
    scene->hits.distance[lane] = 2 + number(random);
    bodies[lane] = lane % 3 == 1 ? Body::ribbon : Body::none;
  }
  list_marked(bodies, Body::ribbon, batch_size, scene->list);
  return scene;
}

struct Found {
  SurfaceBatch points;
  LookBatch looks;
};

std::unique_ptr<Found> found(const Scene& scene, InstructionSet set) {
  choose_instruction_set(set);
  auto result = std::make_unique<Found>();
  scene.hit_surface.find_points(scene.rays, scene.hits, scene.list, clearance_m, result->points,
                                result->looks);
  choose_instruction_set(best_instruction_set());
  return result;
}

TEST(SurfacePoints, lie_where_the_corners_weights_say) {
  const auto scene = random_scene();
  const auto result = found(*scene, best_instruction_set());
  for (std::size_t i = 0; i < scene->list.count; ++i) {
    const std::size_t lane = scene->list.lanes[i];
    const auto corner = scene->surface.triangles.col(scene->hits.triangle[lane]);
    const float u = scene->hits.u[lane];
    const float v = scene->hits.v[lane];
    const Eigen::Vector3f expected = (1 - u - v) * scene->surface.vertices.col(corner[0]) +
                                     u * scene->surface.vertices.col(corner[1]) +
                                     v * scene->surface.vertices.col(corner[2]);
    EXPECT_LT((result->points.position.at(i) - expected).norm(), 1e-6F);
    EXPECT_NEAR(result->points.normal.at(i).norm(), 1, 1e-5F);
    EXPECT_NEAR(result->looks.reach[i], 0.01F * scene->hits.distance[lane] / 0.5F, 1e-6F);
  }
}

// Folded cloth: where the corners' normals cancel or lean away, the facet's own is left.
TEST(SurfacePoints, are_turned_to_who_looks_at_them) {
  const auto scene = random_scene();
  const auto result = found(*scene, best_instruction_set());
  for (std::size_t i = 0; i < scene->list.count; ++i) {
    const std::size_t lane = scene->list.lanes[i];
    const auto corner = scene->surface.triangles.col(scene->hits.triangle[lane]);
    const auto edge = [&](int to) -> Eigen::Vector3f {
      return scene->surface.vertices.col(corner[to]) - scene->surface.vertices.col(corner[0]);
    };
    Eigen::Vector3f facet = edge(1).cross(edge(2)).normalized();
    const bool front = facet.dot(scene->rays.direction.at(lane)) < 0;
    EXPECT_EQ(result->looks.front[i], front ? 1 : 0);
    if (!front) facet = -facet;
    EXPECT_GT(result->points.normal.at(i).dot(facet), 0);
    const Eigen::Vector3f lift = result->points.start.at(i) - result->points.position.at(i);
    EXPECT_GT(lift.norm(), 0.9F * clearance_m);
  }
}

TEST(SurfacePoints, are_the_same_bits_with_all_instruction_sets) {
  const auto scene = random_scene();
  const auto plain = found(*scene, InstructionSet::baseline);
  const auto widest = found(*scene, best_instruction_set());
  const auto expect_same = [&](const Lanes<float>& a, const Lanes<float>& b) {
    EXPECT_TRUE(std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(scene->list.count),
                           b.begin()));
  };
  for (const auto member : {&SurfaceBatch::position, &SurfaceBatch::start, &SurfaceBatch::normal}) {
    expect_same((plain->points.*member).x, (widest->points.*member).x);
    expect_same((plain->points.*member).y, (widest->points.*member).y);
    expect_same((plain->points.*member).z, (widest->points.*member).z);
  }
  for (const auto member : {&LookBatch::x, &LookBatch::y, &LookBatch::front, &LookBatch::reach})
    expect_same(plain->looks.*member, widest->looks.*member);
}

TEST(PatternColors, are_those_of_one_look_after_the_other) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> number(0, 1);
  LookBatch looks;
  for (std::size_t i = 0; i < batch_size; ++i) {
    looks.x[i] = 40 * number(random) - 2;
    looks.y[i] = number(random);
    looks.front[i] = i % 3 == 0 ? 0 : 1;
    looks.reach[i] = 0.3F * number(random) * number(random);
  }
  for (const InstructionSet set : {InstructionSet::baseline, best_instruction_set()}) {
    choose_instruction_set(set);
    VectorLanes colors;
    pattern_colors(looks, batch_size - 5, colors, 5);
    for (std::size_t i = 0; i < batch_size - 5; ++i) {
      const Color expected = looks.front[i] > 0
                                 ? cloth_front(looks.x[i], looks.y[i], looks.reach[i])
                                 : cloth_back(looks.x[i], looks.y[i], looks.reach[i]);
      EXPECT_EQ(colors.at(i + 5), expected.matrix());
    }
  }
  choose_instruction_set(best_instruction_set());
}

}  // namespace ribbon::surface_points_test
