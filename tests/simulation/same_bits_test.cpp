// The same scene gives the same bits, whichever compiler and options built it.
#include <gtest/gtest.h>

#include <cstdint>

#include "geometry/hash_of_positions.h"
#include "simulation/fastening_processor.h"
#include "simulation/loop_scene.h"

namespace ribbon::same_bits_test {

// Drawn onto the post until it touches it all round.
std::uint64_t hash_after_fastening(IntegrationMethod integrator) {
  Scene scene = scene_of_loop();
  scene.fastening->speed_m_s = 1.5;
  scene.time.integrator = integrator;
  auto fastening = FasteningProcessor::create(scene, mesh_of_loop(scene), post(0.3)).value();
  for (int step = 0; step < 60; ++step) fastening.step();
  EXPECT_GT(fastening.tightness()->contact_share, 0.2);
  return hash_of(fastening.positions());
}

// Made by GCC 12 without sanitizers; the sanitizers' build is Clang's, with other optimisation.
TEST(SameBits, come_from_every_build) {
  EXPECT_EQ(hash_after_fastening(IntegrationMethod::rk4), 4538028827883203261U);
  EXPECT_EQ(hash_after_fastening(IntegrationMethod::symplectic_euler), 17206383510253289961U);
  EXPECT_EQ(hash_after_fastening(IntegrationMethod::implicit), 4649373647862279369U);
}

}  // namespace ribbon::same_bits_test
