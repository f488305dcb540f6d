#include "player/render/coverage.h"

#include <gtest/gtest.h>

#include "geometry/solids.h"
#include "player/quads.h"
#include "player/view/framing.h"

namespace ribbon::coverage_test {

Surface square(float left, float right, float bottom, float top, float z) {
  return creased_surface(
      quad_mesh({left, bottom, z}, {right, bottom, z}, {right, top, z}, {left, top, z}));
}

// Sees x, y from -1 to 1 at z = 0, on 64 x 64 pixels: 4 x 4 tiles of 16.
Camera unit_camera() {
  Camera camera;
  camera.eye = {0, 0, 1};
  return camera;
}

int covered_tiles(const TileCoverage& tiles) {
  int count = 0;
  for (int row = 0; row < tiles.rows(); ++row)
    for (int column = 0; column < tiles.columns(); ++column)
      count += tiles.covered(column, row) ? 1 : 0;
  return count;
}

TEST(TileCoverage, only_the_tiles_that_are_touched) {
  TileCoverage tiles(unit_camera(), {64, 64}, 16);
  EXPECT_EQ(covered_tiles(tiles), 0);
  tiles.mark(square(0.1F, 0.3F, 0.6F, 0.9F, 0));  // pixels 35-42 x 3-13
  EXPECT_EQ(covered_tiles(tiles), 1);
  EXPECT_TRUE(tiles.covered(2, 0));
}

TEST(TileCoverage, samples_reach_over_from_the_neighbouring_pixel) {
  TileCoverage tiles(unit_camera(), {64, 64}, 16);
  tiles.mark(square(0.02F, 0.3F, 0.6F, 0.9F, 0));  // begins at pixel 32.6, tile 2
  EXPECT_TRUE(tiles.covered(1, 0));
}

TEST(TileCoverage, sizes_that_are_no_multiple_have_a_last_tile) {
  TileCoverage tiles(unit_camera(), {65, 17}, 16);
  EXPECT_EQ(tiles.columns(), 5);
  EXPECT_EQ(tiles.rows(), 2);
  tiles.mark(square(-9, 9, -9, 9, 0));
  EXPECT_EQ(covered_tiles(tiles), 10);
}

TEST(TileCoverage, what_lies_beside_the_eye_may_be_anywhere) {
  TileCoverage tiles(unit_camera(), {64, 64}, 16);
  tiles.mark(square(-0.1F, 0.1F, -0.1F, 0.1F, 1));
  EXPECT_EQ(covered_tiles(tiles), 16);
}

}  // namespace ribbon::coverage_test
