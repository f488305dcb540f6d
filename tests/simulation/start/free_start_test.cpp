#include "simulation/start/free_start.h"

#include <gtest/gtest.h>

#include "curve/space_curve.h"
#include "parallel/any_threads.h"
#include "result/refusal.h"
#include "simulation/fastening_processor.h"
#include "simulation/frame_judge.h"
#include "simulation/loop_scene.h"
#include "simulation/state/state_archive.h"
#include "simulation/step/gated_step.h"

namespace ribbon::free_start_test {

using Eigen::Matrix3Xd;

// A loop drawn with one crossing, 1.3 m long; its passages have room for a band of 0.24 m.
Scene scene_of_crossing(double width_m) {
  Scene scene;
  scene.name = "crossing";
  scene.curve.drawing = DrawnPoints{{{-300, 100},
                                     {-120, 60},
                                     {60, -20},
                                     {120, -120},
                                     {0, -200},
                                     {-120, -120},
                                     {-60, -20},
                                     {120, 60},
                                     {300, 100}}};
  scene.curve.clearance_m = 0.1 * width_m;
  scene.ribbon = {.width_m = width_m, .along = 60, .across = 5, .mass_kg = 0.1};
  scene.springs = {.stretch = 10, .shear = 10, .bend = 5};
  scene.air_resistance_per_s = 5;
  scene.fastening = FasteningScene{.speed_m_s = 0.2};
  scene.time = {.step_s = 0.01, .duration_s = 1};
  return scene;
}

RibbonMesh mesh_of(const Scene& scene) {
  const auto curve = generate_space_curve(scene.curve, scene.ribbon, TightPassage::squeeze);
  return generate_ribbon_mesh(curve.value(), scene.ribbon, scene.curve.axis);
}

// Free at the start, with the guaranteed gap, and in the steps that follow.
void expect_free(FasteningProcessor& fastening, const RibbonMesh& mesh,
                 const std::optional<TriangleMesh>& obstacle) {
  const FrameJudge judge(mesh, obstacle);
  EXPECT_TRUE(judge.is_free(fastening.positions()));
  EXPECT_GT(fastening.guaranteed_gap_m(), 0);
  EXPECT_GE(judge.gap_m(fastening.positions()), fastening.guaranteed_gap_m());
  for (int step = 0; step < 10; ++step) fastening.step();
  EXPECT_TRUE(judge.is_free(fastening.positions()));
  EXPECT_GE(judge.gap_m(fastening.positions()), fastening.guaranteed_gap_m());
}

StartKind start_of_width(double width_m) {
  const Scene scene = scene_of_crossing(width_m);
  const RibbonMesh mesh = mesh_of(scene);
  auto fastening = FasteningProcessor::create(scene, mesh, std::nullopt).value();
  expect_free(fastening, mesh, std::nullopt);
  return fastening.start().kind;
}

TEST(FreeStart, a_ribbon_with_room_starts_as_generated) {
  EXPECT_EQ(start_of_width(0.03), StartKind::free);
  EXPECT_EQ(start_of_width(0.15), StartKind::free);
}

TEST(FreeStart, a_ribbon_too_wide_for_its_crossing_is_grown_into_it) {
  EXPECT_EQ(start_of_width(0.3), StartKind::grown);
  EXPECT_EQ(start_of_width(0.6), StartKind::grown);
}

TEST(FreeStart, a_grown_ribbon_has_not_fallen) {
  Scene scene = scene_of_crossing(0.45);
  const RibbonMesh mesh = mesh_of(scene);
  const auto without = FasteningProcessor::create(scene, mesh, std::nullopt).value();
  ASSERT_EQ(without.start().kind, StartKind::grown);
  scene.gravity_m_s2 = Eigen::Vector3d(0, -9.81, 0);
  const auto with = FasteningProcessor::create(scene, mesh, std::nullopt).value();
  EXPECT_EQ(with.positions(), without.positions());
}

TEST(FreeStart, a_grown_ribbon_has_its_rest_size) {
  const Scene scene = scene_of_crossing(0.45);
  const RibbonMesh mesh = mesh_of(scene);
  const auto fastening = FasteningProcessor::create(scene, mesh, std::nullopt).value();
  ASSERT_EQ(fastening.start().kind, StartKind::grown);
  const Matrix3Xd& positions = fastening.positions();
  const double across_m = 0.45 / 4;
  int short_edges = 0;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 4; ++j) {
      const int particle = mesh.grid.particle(i, j);
      const double length_m = (positions.col(particle + 1) - positions.col(particle)).norm();
      if (length_m < 0.85 * across_m || length_m > 1.15 * across_m) ++short_edges;
    }
  EXPECT_LE(short_edges, 5);  // 1 % of all edges, along and across
}

// A square round the axis at a height.
TriangleMesh level(float height) {
  return quad_mesh({-2, height, 2}, {2, height, 2}, {2, height, -2}, {-2, height, -2});
}

// A ring-shaped box round the loop: 24 cm high inside, 4 cm deep.
TriangleMesh ring_box() {
  return together(together(post(0.48, 60), post(0.52, 60)), together(level(0.12F), level(-0.12F)));
}

TEST(FreeStart, a_ribbon_without_room_is_refused_with_a_width_that_found_room) {
  Scene scene = scene_of_loop();
  scene.ribbon.width_m = 0.5;
  const std::string sentence =
      refusal_of(FasteningProcessor::create(scene, mesh_of_loop(scene), ring_box()));
  EXPECT_THAT(sentence, HasSubstr("no room for its width of 0.5 m"));
  EXPECT_THAT(sentence, HasSubstr("strained most at row "));
  const std::string remedy = "; set ribbon.width to ";
  ASSERT_THAT(sentence, HasSubstr(remedy));
  scene.ribbon.width_m = std::stod(sentence.substr(sentence.find(remedy) + remedy.size()));
  EXPECT_GT(scene.ribbon.width_m, 0.05);
  const RibbonMesh mesh = mesh_of_loop(scene);
  auto fastening = FasteningProcessor::create(scene, mesh, ring_box());
  ASSERT_TRUE(fastening.has_value()) << fastening.error().sentence();
  expect_free(*fastening, mesh, ring_box());
}

TEST(FreeStart, is_given_up_whenever_the_observer_wants) {
  const Scene scene = scene_of_crossing(0.45);
  const RibbonMesh mesh = mesh_of(scene);
  for (const int asked : {1, 2, 10}) {
    int told = 0;
    const auto found = FasteningProcessor::create(
        scene, mesh, std::nullopt, [&](const std::string&) { return ++told < asked; });
    EXPECT_EQ(told, asked);
    EXPECT_EQ(refusal_of(found),
              "crossing: was interrupted while its start was looked for; run it again");
    EXPECT_TRUE(found.error().may_pass);
  }
}

TEST(FreeStart, an_absurd_width_is_refused_with_row_and_remedy) {
  const Scene scene = scene_of_crossing(30);
  const std::string sentence =
      refusal_of(FasteningProcessor::create(scene, mesh_of(scene), std::nullopt));
  EXPECT_THAT(sentence, StartsWith("crossing: "));
  EXPECT_THAT(sentence, AllOf(HasSubstr("row "), HasSubstr(" of 60, "), HasSubstr("ribbon.width")));
}

// The post moved along z, so that it stands in the ribbon's way at the far side.
TriangleMesh post_in_the_way(double depth_m) {
  TriangleMesh mesh = post(0.3, 60);
  mesh.vertices.row(2).array() -= static_cast<float>(loop_radius_m - 0.3 + depth_m);
  return mesh;
}

// Walls across the loop, so many that there is no room between them.
TriangleMesh walls() {
  TriangleMesh all;
  for (int wall = 0; wall < 12; ++wall) {
    const float z = 0.08F * static_cast<float>(wall) - 0.48F;
    all = together(all, quad_mesh({-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z}));
  }
  return all;
}

TEST(FreeStart, a_ribbon_that_the_obstacle_is_in_the_way_of_is_moved_out_of_it) {
  const Scene scene = scene_of_loop();
  const RibbonMesh mesh = mesh_of_loop(scene);
  const TriangleMesh obstacle = post_in_the_way(0.03);
  auto fastening = FasteningProcessor::create(scene, mesh, obstacle).value();
  EXPECT_EQ(fastening.start().kind, StartKind::recovered);
  EXPECT_GT(fastening.start().recovery_iterations, 0);
  expect_free(fastening, mesh, obstacle);
}

TEST(FreeStart, an_obstacle_that_reaches_a_selvage_only_leaves_room_for_the_thin_band) {
  // A floor under the loop, 5 mm over the lowest selvage.
  const Scene scene = scene_of_loop();
  const RibbonMesh mesh = mesh_of_loop(scene);
  const auto height = static_cast<float>(mesh.positions.row(1).minCoeff() + 0.005);
  const TriangleMesh floor = level(height);
  auto fastening = FasteningProcessor::create(scene, mesh, floor).value();
  EXPECT_EQ(fastening.start().kind, StartKind::grown);
  expect_free(fastening, mesh, floor);
  EXPECT_GT(fastening.positions().row(1).minCoeff(), height);
}

TEST(FreeStart, an_obstacle_through_the_middle_of_the_ribbon_is_refused_with_row_and_remedy) {
  const Scene scene = scene_of_loop();
  EXPECT_THAT(refusal_of(FasteningProcessor::create(scene, mesh_of_loop(scene), walls())),
              AllOf(HasSubstr("meets the obstacle at row "), HasSubstr("obstacle.position")));
}

TEST(FreeStart,
     a_tight_passage_of_the_drawing_is_told_where_the_strands_lack_room_and_nowhere_else) {
  Scene scene = scene_of_crossing(30);
  const auto refusal = [&](const RibbonMesh& mesh, const std::optional<TriangleMesh>& obstacle) {
    return refusal_of(FasteningProcessor::create(scene, mesh, obstacle));
  };
  const RibbonMesh tight = mesh_of(scene);
  ASSERT_TRUE(tight.squeezed.has_value());
  EXPECT_THAT(refusal(tight, std::nullopt), HasSubstr("(drawing at ("));
  scene.springs.stretch = 1e9;
  scene.time.integrator = IntegrationMethod::symplectic_euler;
  EXPECT_THAT(refusal(tight, std::nullopt), Not(HasSubstr("drawing at")));
  scene = scene_of_loop();
  RibbonMesh loop = mesh_of_loop(scene);
  loop.squeezed = tight.squeezed;
  EXPECT_THAT(refusal(loop, walls()), Not(HasSubstr("drawing at")));
}

TEST(FreeStart, is_the_same_to_the_bit_for_any_number_of_threads) {
  const Scene scene = scene_of_crossing(0.4);
  const RibbonMesh mesh = mesh_of(scene);
  same_for_any_threads([&] {
    const auto fastening = FasteningProcessor::create(scene, mesh, std::nullopt).value();
    EXPECT_EQ(fastening.start().kind, StartKind::grown);
    return fastening.positions();
  });
}

std::string state_of(Bodies& bodies) {
  StateArchive archive;
  bodies.visit_state(archive);
  return archive.bytes();
}

// The schemes build what they look for penetrations with.
TEST(FreeStart, leaves_behind_nothing_that_the_gate_does_without) {
  const Scene scene = scene_of_loop();
  const RibbonMesh mesh = mesh_of_loop(scene);
  const TriangleMesh obstacle = post_in_the_way(0.03);
  Bodies bodies{mesh.grid, ObstacleBody(obstacle.triangles, obstacle.vertices.cast<double>())};
  Bodies untouched{mesh.grid, std::nullopt};
  Cloth cloth{mesh.positions, Matrix3Xd::Zero(3, mesh.positions.cols()), 0.001};
  const ContactLengths lengths = contact_lengths(scene, mesh.size());
  const auto start = find_free_start(scene, mesh, lengths, {}, {}, bodies, cloth);
  EXPECT_EQ(start->kind, StartKind::recovered);
  GatedStep(scene, mesh.size(), lengths, cloth.particle_mass_kg).take(nullptr, bodies, cloth);
  EXPECT_EQ(state_of(bodies), state_of(untouched));
  bodies.ribbon.triangle_bvh(cloth.positions);
  EXPECT_NE(state_of(bodies), state_of(untouched)) << "which would tell";
}

TEST(FreeStart, as_published_recovers_what_it_can_and_counts_the_rest) {
  Scene scene = scene_of_loop();
  scene.contact = ContactMethod::paper;
  const RibbonMesh mesh = mesh_of_loop(scene);
  const auto touched = FasteningProcessor::create(scene, mesh, post_in_the_way(0.001)).value();
  EXPECT_EQ(touched.start().kind, StartKind::recovered);
  EXPECT_GT(touched.start().recovery_iterations, 0);
  EXPECT_EQ(touched.guaranteed_gap_m(), 0);
  EXPECT_EQ(touched.start().penetrating_edges, 0);
  auto cut = FasteningProcessor::create(scene, mesh, walls()).value();
  EXPECT_GT(cut.start().penetrating_edges, 0);
  EXPECT_GT(cut.step().penetrating_edges, 0);
}

}  // namespace ribbon::free_start_test
