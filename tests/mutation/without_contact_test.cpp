// Without contact, or without the gate alone, what they prevent must happen, and both oracles must
// see it: otherwise nothing that they say of the product's recordings would mean anything.
#include <gtest/gtest.h>

#include "curve/space_curve.h"
#include "obstacle/obstacle.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"
#include "simulation/fastening_processor.h"
#include "verification/cgal_oracle.h"
#include "verification/frame_verifier.h"

namespace ribbon::without_contact_test {

class WithoutContact : public testing::TestWithParam<const char*> {};

// Ten times the sample's force, unyielding as published, in steps four times as long: contact
// constraints alone do not stand that.
TEST_P(WithoutContact, both_oracles_find_the_same_intersections) {
  Scene scene = read_scene(std::string(RIBBON_SAMPLES "/") + GetParam()).value();
  scene.fastening->speed_m_s *= 10;
  scene.fastening->yield_strain = unyielding;
  const SpaceCurve curve = generate_space_curve(scene.curve, scene.ribbon).value();
  const RibbonMesh ribbon = generate_ribbon_mesh(curve, scene.ribbon, scene.curve.axis);
  const TriangleMesh obstacle = read_obstacle(*scene.obstacle).value();
  FasteningProcessor fastening = FasteningProcessor::create(scene, ribbon, obstacle).value();
  const FrameVerifier verifier(ribbon.size(), obstacle);

  EXPECT_TRUE(verifier.verify(ribbon.positions.cast<float>()).intersections.pairs.empty());
  Eigen::Matrix3Xf positions;
  FrameVerdict verdict;
  for (int step = 1; step <= 60 && verdict.intersections.pairs.empty(); ++step) {
    fastening.step();
    positions = fastening.positions().cast<float>();
    verdict = verifier.verify(positions);
  }
  EXPECT_FALSE(verdict.intersections.pairs.empty());
  EXPECT_EQ(cgal_intersecting_pairs(verifier.soup(positions)), verdict.intersections.pairs);
}

INSTANTIATE_TEST_SUITE_P(Samples, WithoutContact,
                         testing::Values("overhand-hourglass-8x400.toml",
                                         "overhand-cylinder-8x400.toml",
                                         "overhand-small-object-8x400.toml"));

}  // namespace ribbon::without_contact_test
