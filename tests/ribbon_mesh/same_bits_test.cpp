// The same drawing gives the same ribbon, bit for bit, whichever compiler and options built it.
#include <gtest/gtest.h>

#include "curve/path_data.h"
#include "geometry/hash_of_positions.h"
#include "ribbon_mesh/ribbon_mesh.h"

namespace ribbon::ribbon_same_bits_test {

// A loop of arcs and a cubic, turned and slanted. Made by GCC 12 without sanitizers.
TEST(SameBits, of_a_ribbon_along_arcs_come_from_every_build) {
  const auto transform = read_transform("rotate(33) skewX(10) scale(1.5) rotate(-7, 3, 4)");
  ASSERT_TRUE(transform.has_value());
  const auto path = flatten_path_data(
      "M -300 100 A 260 130 20 0 0 90 -30 A 110 90 -15 1 0 -90 -60 C 0 40 160 90 300 100",
      *transform, 0.01);
  ASSERT_TRUE(path.has_value());
  CurveScene scene;
  scene.drawing = DrawnPoints{path->pieces.at(0)};
  scene.clearance_m = 0.002;
  const auto curve = generate_space_curve(scene, {.width_m = 0.03, .along = 200});
  ASSERT_TRUE(curve.has_value()) << curve.error().sentence();
  EXPECT_EQ(curve->crossings.size(), 1U);
  const RibbonMesh ribbon =
      generate_ribbon_mesh(*curve, {.width_m = 0.03, .along = 200, .across = 5}, Axis::y);
  EXPECT_EQ(hash_of(ribbon.positions), 621700678647311110U);
}

}  // namespace ribbon::ribbon_same_bits_test
