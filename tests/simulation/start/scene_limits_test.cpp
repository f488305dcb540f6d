#include "simulation/start/scene_limits.h"

#include <gtest/gtest.h>

#include <limits>

#include "result/refusal.h"
#include "simulation/fastening_processor.h"
#include "simulation/loop_scene.h"
#include "simulation/truncation/strain_constraints.h"

namespace ribbon::scene_limits_test {

std::string refusal(const Scene& scene, const RibbonMesh& mesh,
                    const std::optional<TriangleMesh>& obstacle = std::nullopt) {
  return refusal_of(FasteningProcessor::create(scene, mesh, obstacle));
}

TEST(SceneLimits, a_ribbon_where_single_precision_is_too_coarse_is_refused_with_the_distance) {
  const Scene scene = scene_of_loop();
  // Its length is 4.09 m, so a coordinate may be off by 4.09e-5 m: half of the spacing of single
  // precision from 686 m on.
  RibbonMesh mesh = mesh_of_loop(scene);
  mesh.positions.row(0).array() += 600;
  EXPECT_EQ(refusal(scene, mesh), "");
  mesh.positions.row(0).array() += 200;
  EXPECT_THAT(refusal(scene, mesh), HasSubstr("loop: the ribbon lies 8"));
  EXPECT_THAT(refusal(scene, mesh), HasSubstr("within 679 m of the origin"));
  EXPECT_THAT(refusal(scene, mesh), HasSubstr("or set recording.max_position_error to 1.1"));
  mesh.positions.row(0).array() += 2e6;
  EXPECT_THAT(refusal(scene, mesh), EndsWith("within 679 m of the origin with curve.origin"))
      << "no scene may have so large an error";
  TriangleMesh obstacle = post(0.4);
  obstacle.vertices.row(0).array() += 2e6F;
  EXPECT_THAT(refusal_of(FasteningProcessor::create(scene, mesh, obstacle)),
              EndsWith("of the origin with curve.origin and obstacle.position"));
}

// What a sentence says to set something to, or to come within.
double number_after(const std::string& sentence, const std::string& words) {
  EXPECT_THAT(sentence, HasSubstr(words));
  return std::stod(sentence.substr(sentence.find(words) + words.size()));
}

// An error that is coarse enough for the place may be too coarse for the edges.
TEST(SceneLimits, what_is_proposed_to_a_ribbon_far_from_the_origin_serves) {
  Scene scene = scene_of_loop();
  const RibbonMesh mesh = mesh_of_loop(scene);
  const auto at = [&](double x_m) {
    RibbonMesh moved = mesh;
    moved.positions.row(0).array() += x_m;
    return moved;
  };
  const std::string set_error = "or set recording.max_position_error to ";
  scene.recording.max_position_error =
      number_after(refusal(scene, at(6500)), set_error);  // nearly as much as edges bear
  const auto far = FasteningProcessor::create(scene, at(6500), std::nullopt);
  ASSERT_TRUE(far) << far.error().sentence();
  EXPECT_NEAR(far->held_strain(), 0.03, 0.003) << "which is the price";
  scene.recording.max_position_error = 1e-5;
  EXPECT_NEAR(FasteningProcessor::create(scene, mesh, std::nullopt)->held_strain(), 0.088, 1e-12);
  const std::string too_far = refusal(scene, at(1e4));
  EXPECT_THAT(too_far, Not(HasSubstr(set_error)));
  const double within_m = number_after(too_far, "move it to within ");
  EXPECT_EQ(refusal(scene, at(within_m - 1)), "");
  scene.recording.max_position_error = 2e-4;
  const std::string too_coarse = refusal(scene, at(1e4));
  const double nearer_m = number_after(too_coarse, " or less and move it to within ");
  scene.recording.max_position_error =
      number_after(too_coarse, "set recording.max_position_error to ");
  EXPECT_EQ(refusal(scene, at(nearer_m - 1)), "");
}

// Neither the origin nor the particles are what is wrong.
TEST(SceneLimits, a_length_and_a_width_that_do_not_fit_are_named) {
  const std::string remedy =
      "; set curve.unit, now 0.001 m, or ribbon.width so that they fit each other";
  for (const double error : {0.0, 1e-5}) {
    Scene scene = scene_of_loop();
    scene.recording.max_position_error = error;
    for (const double size : {1e-9, 1e-6, 1e6, 1e9})
      EXPECT_THAT(refusal(scene, mesh_of_loop(scene, size)),
                  AllOf(HasSubstr("loop: the ribbon is 4.09"), HasSubstr(" long and 0.06 m wide"),
                        EndsWith(remedy)))
          << size;
    for (const double width_m : {1e-12, 1e-7}) {
      scene.ribbon.width_m = width_m;
      EXPECT_THAT(refusal(scene, mesh_of_loop(scene)), EndsWith(remedy)) << width_m;
    }
  }
  Scene long_and_far = scene_of_loop();
  long_and_far.ribbon.width_m = 4.5e-4;
  long_and_far.recording.max_position_error = 1e-7;
  RibbonMesh mesh = mesh_of_loop(long_and_far, 2);
  EXPECT_EQ(refusal(long_and_far, mesh), "");
  mesh.positions.row(0).array() += 1000;
  EXPECT_THAT(refusal(long_and_far, mesh), HasSubstr("; move it to within "))
      << "it is the place that is wrong";
  Scene as_published = scene_of_loop();
  as_published.contact = ContactMethod::paper;
  EXPECT_THAT(refusal(as_published, mesh_of_loop(as_published, 1e-9)), EndsWith(remedy));
  Scene thread = scene_of_loop();
  thread.ribbon.width_m = 2e-4;
  EXPECT_THAT(refusal(thread, mesh_of_loop(thread)),
              HasSubstr("; set recording.max_position_error to 3.31e-07"));
}

TEST(SceneLimits, an_obstacle_where_double_precision_is_too_coarse_is_refused) {
  const Scene scene = scene_of_loop();
  TriangleMesh obstacle = post(0.4);
  obstacle.vertices.row(1) *= 1e6F;
  EXPECT_EQ(refusal(scene, mesh_of_loop(scene), obstacle), "");
  obstacle.vertices.row(1) *= 1e6F;
  EXPECT_THAT(refusal(scene, mesh_of_loop(scene), obstacle), HasSubstr("from the origin, too far"));
  obstacle.vertices(1, 3) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(refusal(scene, mesh_of_loop(scene), obstacle), HasSubstr("too far"));
}

TEST(SceneLimits, a_ribbon_too_wide_for_the_modes_of_the_implicit_scheme_is_refused) {
  Scene scene = scene_of_loop();
  scene.ribbon.along = 30;
  scene.ribbon.across = 501;
  scene.recording.max_position_error = 1e-7;
  scene.time.integrator = IntegrationMethod::implicit;
  EXPECT_THAT(
      refusal(scene, mesh_of_loop(scene)),
      HasSubstr("loop: the ribbon is 501 particles wide, more than the 500 that time.integrator = "
                "\"implicit\" takes; set a smaller ribbon.across"));
}

TEST(SceneLimits, a_recording_too_coarse_for_edges_and_gap_is_refused_with_an_error_that_serves) {
  Scene scene = scene_of_loop();
  const RibbonMesh mesh = mesh_of_loop(scene);
  scene.recording.max_position_error = 0.01;
  const std::string sentence = refusal(scene, mesh);
  const std::string remedy = "set recording.max_position_error to ";
  ASSERT_THAT(sentence, HasSubstr(remedy));
  scene.recording.max_position_error =
      std::stod(sentence.substr(sentence.find(remedy) + remedy.size()));
  EXPECT_EQ(refusal(scene, mesh), "");
  *scene.recording.max_position_error *= 1.02;
  EXPECT_NE(refusal(scene, mesh), "");
  scene.contact = ContactMethod::paper;  // which promises nothing
  EXPECT_EQ(refusal(scene, mesh), "");
}

// Of the ribbon's length, where the scene leaves it out.
double usual_error(Scene scene) {
  scene.recording.max_position_error.reset();
  return with_rounding(scene, mesh_of_loop(scene).size(), 0).recording.max_position_error.value();
}

TEST(SceneLimits, an_error_that_is_left_out_is_as_small_as_edges_along_need) {
  Scene scene = scene_of_loop();
  scene.ribbon.along = 600;
  EXPECT_EQ(usual_error(scene), 1e-5);
  scene.ribbon.along = 1200;
  const RestSize size = mesh_of_loop(scene).size();
  EXPECT_LT(usual_error(scene), 6e-6);
  EXPECT_NEAR(aimed_strain(0.08, size.along_m(), usual_error(scene) * size.length_m), 0.07, 1e-9);
}

TEST(SceneLimits, an_error_that_is_left_out_is_as_small_as_the_edges_need) {
  Scene scene = scene_of_loop();
  EXPECT_EQ(usual_error(scene), 1e-5);
  scene.ribbon.across = 40;  // too many for that error
  const RestSize size = mesh_of_loop(scene).size();
  EXPECT_THAT(refusal(scene, mesh_of_loop(scene)), HasSubstr("or fewer particles"));
  EXPECT_LT(usual_error(scene), 1e-5);
  EXPECT_NEAR(aimed_strain(0.08, size.shortest_edge_m(), usual_error(scene) * size.length_m), 0.05,
              1e-9);
  scene.recording.max_position_error.reset();
  const auto fastening = FasteningProcessor::create(scene, mesh_of_loop(scene), std::nullopt);
  ASSERT_TRUE(fastening.has_value());
  EXPECT_EQ(fastening->max_position_error_m(), usual_error(scene) * size.length_m);
  scene.ribbon.across = 4000;
  EXPECT_EQ(usual_error(scene), 1e-7);
  EXPECT_THAT(refusal(scene, mesh_of_loop(scene)), HasSubstr("; set fewer particles, or"))
      << "no smaller error can be asked for";
  scene.contact = ContactMethod::paper;  // which promises nothing
  EXPECT_EQ(usual_error(scene), 1e-5);
}

TEST(SceneLimits, without_loss_the_gap_survives_rounding_to_single_precision) {
  Scene scene = scene_of_loop();
  scene.recording.max_position_error = 0;
  auto fastening = FasteningProcessor::create(scene, mesh_of_loop(scene), post(0.3)).value();
  // The loop reaches 0.5 m and is 4.09 m long.
  EXPECT_EQ(fastening.reach_m(), 16);
  EXPECT_EQ(fastening.max_position_error_m(), 0);
  scene.recording.max_position_error = 1e-5;
  const double lossy_gap_m =
      FasteningProcessor::create(scene, mesh_of_loop(scene), post(0.3))->guaranteed_gap_m();
  EXPECT_GT(fastening.guaranteed_gap_m(), lossy_gap_m);
  const double edge_m = 0.06 / 3;
  EXPECT_NEAR(fastening.guaranteed_gap_m(), 0.05 * edge_m, 1e-5 * edge_m + 4 * 16 * 0x1p-25);
  EXPECT_LT(fastening.guaranteed_gap_m(), 0.05 * edge_m - 3 * 16 * 0x1p-25);
}

TEST(SceneLimits, without_loss_a_ribbon_so_far_away_that_single_precision_lets_it_meet_is_refused) {
  Scene scene = scene_of_loop();
  scene.recording.max_position_error = 0;
  RibbonMesh mesh = mesh_of_loop(scene);
  mesh.positions.row(0).array() += 600;
  EXPECT_EQ(refusal(scene, mesh), "");
  mesh.positions.row(0).array() += 60000;
  EXPECT_THAT(refusal(scene, mesh), HasSubstr("loop: recording in single precision may move"));
  // A quarter of that leaves a gap, but may strain its edges of 2 cm by more than is left to it.
  mesh.positions.row(0).array() -= 45000;
  EXPECT_THAT(refusal(scene, mesh),
              AllOf(HasSubstr("loop: recording in single precision may move"),
                    HasSubstr("too much to keep edges of 0.02 m within 10 %"),
                    EndsWith("or move the ribbon to the origin with curve.origin")));
  mesh.positions.row(0).array() -= 10000;
  const std::string sentence = refusal(scene, mesh);
  scene.recording.max_position_error =
      number_after(sentence, "with curve.origin, or set recording.max_position_error to ");
  EXPECT_EQ(refusal(scene, mesh), "") << "which may be finer than what is prepared for without";
  scene.contact = ContactMethod::paper;
  EXPECT_EQ(refusal(scene, mesh), "");
}

TEST(SceneLimits, springs_that_would_take_for_ever_are_refused) {
  Scene scene = scene_of_loop();
  scene.time.integrator = IntegrationMethod::symplectic_euler;
  scene.springs.stretch = 1e12;
  EXPECT_THAT(refusal(scene, mesh_of_loop(scene)),
              AllOf(HasSubstr("more than 1200; set smaller resistances"),
                    HasSubstr("or time.integrator to \"implicit\"")));
}

TEST(SceneLimits, springs_too_stiff_for_the_usual_integrator_get_the_implicit_one) {
  Scene scene = scene_of_loop();
  const auto states_after = [&](int steps) {
    auto fastening = FasteningProcessor::create(scene, mesh_of_loop(scene), std::nullopt).value();
    for (int step = 0; step < steps; ++step) fastening.step();
    return fastening.state();
  };
  const std::string soft = states_after(5);
  scene.time.integrator = IntegrationMethod::symplectic_euler;
  EXPECT_EQ(states_after(5), soft);
  scene.time.integrator.reset();
  scene.springs.stretch = 1e12;
  const std::string stiff = states_after(5);
  scene.time.integrator = IntegrationMethod::implicit;
  EXPECT_EQ(states_after(5), stiff);
}

// What hangs does not rest in the implicit one.
TEST(SceneLimits, springs_that_swing_very_fast_keep_the_usual_scheme_where_it_may_divide_the_step) {
  Scene scene = scene_of_loop();
  const auto chosen = [&] {
    return FasteningProcessor::create(scene, mesh_of_loop(scene), std::nullopt).value();
  };
  scene.springs.stretch = 2e5;
  EXPECT_EQ(chosen().integrator(), IntegrationMethod::symplectic_euler);
  EXPECT_GT(chosen().substeps(), 200);
  scene.time.step_s = 0.1;
  EXPECT_EQ(chosen().integrator(), IntegrationMethod::implicit);
}

TEST(SceneLimits, springs_too_stiff_for_a_ribbon_too_wide_for_the_implicit_scheme_are_refused) {
  Scene scene = scene_of_loop();
  scene.ribbon.along = 30;
  scene.ribbon.across = 501;
  scene.recording.max_position_error = 1e-7;
  EXPECT_EQ(refusal(scene, mesh_of_loop(scene)), "");
  scene.springs.stretch = 1e12;
  EXPECT_THAT(refusal(scene, mesh_of_loop(scene)), HasSubstr("or a ribbon.across of at most 500"));
}

// Where contact acts once a step, springs may not swing many times between; in Runge-Kutta's parts
// least of all where bending resists most.
TEST(SceneLimits, contact_as_published_takes_fewer_parts_of_a_step) {
  Scene scene = scene_of_loop();
  scene.time.integrator = IntegrationMethod::symplectic_euler;
  scene.springs = {.stretch = 1000, .shear = 0, .bend = 1000};
  scene.contact = ContactMethod::paper;
  EXPECT_EQ(refusal(scene, mesh_of_loop(scene)), "");
  scene.springs.stretch = 2000;
  EXPECT_THAT(refusal(scene, mesh_of_loop(scene)),
              HasSubstr("more than 38 that contact = \"paper\" takes;"));
  scene.springs.stretch = 0;
  scene.time.integrator = IntegrationMethod::rk4;
  EXPECT_THAT(refusal(scene, mesh_of_loop(scene)),
              HasSubstr("more than 12 that contact = \"paper\" takes where bending resists most"));
  scene.contact = ContactMethod::gate;
  EXPECT_EQ(refusal(scene, mesh_of_loop(scene)), "");
}

}  // namespace ribbon::scene_limits_test
