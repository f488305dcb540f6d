// What SIGKILL leaves can be played and goes on; tests/soak.sh kills takes the same five hundred
// times.
#include <gtest/gtest.h>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "recorder/killed_runs.h"
#include "recorder/small_scene.h"

namespace ribbon::kill_test {

namespace fs = std::filesystem;

TEST(KilledRun, plays_and_goes_on_to_the_same_bits) {
  const TemporaryFolder own;
  const fs::path& folder = own.path();
  const std::string text = small_scene_text("6") + "checkpoint_every = 1\n";
  ASSERT_TRUE(write_file(folder / "long.toml", text).has_value());
  const KillReport report = kill_and_resume(RIBBON_RECORD, folder / "long.toml", folder, 10, 20241);
  EXPECT_EQ(report.problem, "");
  EXPECT_EQ(report.kills, 10);
  EXPECT_GT(report.of_resumed_runs, 1);
  EXPECT_LT(report.came_to_their_end, 7);
  EXPECT_GT(report.frames_played, 200);
  EXPECT_GT(report.frames_resumed, 4 * 181);
}

}  // namespace ribbon::kill_test
