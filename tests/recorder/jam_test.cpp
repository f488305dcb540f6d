// What becomes of a ribbon that hands have drawn into a jam, at the limit of its strain.
#include <gtest/gtest.h>

#include <filesystem>

#include "files/files.h"
#include "obstacle/obstacle.h"
#include "recorder/run/start.h"

namespace ribbon::jam_test {

// Without shear springs, hardly bent and drawn at 2 m/s, it folds where it is tight. There its own
// springs would strain an edge beyond the limit, even from rest and without hands.
TEST(Jam, is_no_end_of_all_motion) {
  const auto file = std::filesystem::path(RIBBON_SAMPLES) / "overhand-hourglass-8x400.toml";
  const Scene scene = read_scene(file, read_file(file).value(),
                                 {"ribbon.along=60", "ribbon.across=3", "springs.shear=0",
                                  "springs.bend=1", "fastening.speed=2", "fastening.yield=never"})
                          .value();
  auto [ribbon, fastening] = find_start(scene, read_obstacle(scene).value()).value();
  int still = 0;
  for (int step = 0; step < 200; ++step) {
    const Eigen::Matrix3Xd before = fastening.positions();
    fastening.step();
    still += fastening.positions() == before ? 1 : 0;
    ASSERT_LE(fastening.strain(), 0.1) << step;
  }
  EXPECT_EQ(still, 0);
}

}  // namespace ribbon::jam_test
