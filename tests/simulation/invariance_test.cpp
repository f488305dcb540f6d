// The same scene elsewhere, turned, mirrored, larger or heavier moves in the same way.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>

#include "simulation/fastening_processor.h"
#include "simulation/frame_judge.h"
#include "simulation/loop_scene.h"

namespace ribbon::invariance_test {

using Eigen::Affine3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr std::array all_methods = {IntegrationMethod::rk4, IntegrationMethod::symplectic_euler,
                                    IntegrationMethod::implicit};

// The loop and its post can be put elsewhere. The thick post is touched after some twenty steps,
// the thin one after more than sixty.
constexpr double thick_m = 0.45;
constexpr double thin_m = 0.4;
constexpr int steps_before_contact = 40;
constexpr int steps_into_contact = 80;

struct Placed {
  Scene scene = scene_of_loop();
  RibbonMesh mesh = mesh_of_loop(scene);
  TriangleMesh obstacle;
  Affine3d place = Affine3d::Identity();

  Placed(IntegrationMethod method, double post_radius_m) : obstacle(post(post_radius_m)) {
    scene.time.integrator = method;
  }

  // By a motion or a mirror.
  void put(const Affine3d& where) {
    place = where;
    mesh.positions = where * mesh.positions;
    scene.fastening->axis_point_m = where * scene.fastening->axis_point_m;
    scene.fastening->axis_direction = where.linear() * scene.fastening->axis_direction;
    obstacle.vertices = (where * obstacle.vertices.cast<double>()).cast<float>();
  }

  void enlarge(double times) {
    place.scale(times);
    mesh.positions *= times;
    mesh.length_m *= times;
    mesh.width_m *= times;
    scene.ribbon.width_m *= times;
    scene.fastening->speed_m_s *= times;
    obstacle.vertices *= static_cast<float>(times);
  }

  void make_heavier(double times) {
    scene.ribbon.mass_kg *= times;
    for (double* resistance : {&scene.springs.stretch, &scene.springs.shear, &scene.springs.bend})
      *resistance *= times;
  }

  // After so many steps, seen as before it was put elsewhere.
  [[nodiscard]] Matrix3Xd after(int steps) const {
    auto fastening = FasteningProcessor::create(scene, mesh, obstacle).value();
    for (int step = 0; step < steps; ++step) fastening.step();
    return place.inverse() * fastening.positions();
  }
};

const Affine3d turned(Eigen::AngleAxisd(1, Vector3d(1, 2, -2) / 3));
const Affine3d moved(Eigen::Translation3d(300, -200, 500));
const Affine3d mirrored(Eigen::Scaling(-1.0, 1.0, 1.0));

// The largest distance (m) between equal particles before contact, here and there.
double difference_m(IntegrationMethod method, const Affine3d& where,
                    int steps = steps_before_contact) {
  const Placed here(method, thin_m);
  Placed there = here;
  there.put(where);
  return (there.after(steps) - here.after(steps)).colwise().norm().maxCoeff();
}

// Within the first step coordinates up to 1 m are rounded by 1.1e-16 m at a time. After it
// velocities up to 0.4 m/s are rounded by 1.5e-8 m/s, and so after each other: by 6e-9 m in 40
// steps of 0.01 s. The motion is smooth: rounding adds up, but does not grow by itself.
TEST(Invariance, a_turned_scene_moves_alike_to_rounding) {
  for (const IntegrationMethod method : all_methods) {
    EXPECT_LT(difference_m(method, turned, 1), 2e-15) << static_cast<int>(method);
    EXPECT_LT(difference_m(method, turned), 6e-9) << static_cast<int>(method);
  }
}

// Coordinates up to 500 m are rounded by 5.7e-14 m at a time.
TEST(Invariance, a_moved_scene_moves_alike_to_rounding) {
  for (const IntegrationMethod method : all_methods) {
    EXPECT_LT(difference_m(method, moved, 1), 1e-12) << static_cast<int>(method);
    EXPECT_LT(difference_m(method, moved), 6e-9) << static_cast<int>(method);
  }
}

// Rounding knows no sign: nothing may prefer a hand.
TEST(Invariance, a_mirrored_scene_moves_by_the_same_bits) {
  for (const IntegrationMethod method : all_methods)
    EXPECT_EQ(difference_m(method, mirrored), 0) << static_cast<int>(method);
}

// Powers of two leave all digits as they are: a difference would come from a length or a mass that
// is not in proportion to the scene's.
void expect_the_same_bits_in_contact(void (Placed::*scale)(double), double times) {
  for (const IntegrationMethod method : all_methods)
    for (const double by : {times, 1 / times}) {
      const Placed here(method, thick_m);
      Placed there = here;
      (there.*scale)(by);
      EXPECT_EQ(there.after(steps_into_contact), here.after(steps_into_contact))
          << static_cast<int>(method) << ", times " << by;
    }
}

TEST(Invariance, a_scene_of_another_size_moves_by_the_same_bits_even_in_contact) {
  expect_the_same_bits_in_contact(&Placed::enlarge, 0x1p20);
}

TEST(Invariance, a_scene_of_another_mass_moves_by_the_same_bits_even_in_contact) {
  expect_the_same_bits_in_contact(&Placed::make_heavier, 0x1p30);
}

// In contact the order of rounding decides what gives way first; the promise stays.
TEST(Invariance, wherever_it_is_put_the_scene_stays_free_in_contact) {
  for (const Affine3d& where : {turned, moved, mirrored}) {
    Placed there(IntegrationMethod::rk4, thick_m);
    there.put(where);
    auto fastening = FasteningProcessor::create(there.scene, there.mesh, there.obstacle).value();
    const FrameJudge judge(there.mesh, there.obstacle);
    for (int step = 0; step < steps_into_contact; ++step) {
      fastening.step();
      ASSERT_TRUE(judge.is_free(fastening.positions())) << step;
    }
    EXPECT_GT(fastening.tightness()->contact_share, 0);
  }
}

}  // namespace ribbon::invariance_test
