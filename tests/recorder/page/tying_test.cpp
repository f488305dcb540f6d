// A run that can be looked at, and ended, between any two frames.
#include "recorder/page/tying.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files/temporary_folder.h"
#include "playback/recording_reader.h"
#include "recorder/record.h"
#include "recorder/small_scene.h"
#include "recorder/test_runs.h"

namespace ribbon::tying_test {

using ::testing::HasSubstr;

class TyingInAPage : public TestInFolder {
 protected:
  TyingInAPage() : scene_(write_small_scene(folder_)) {}

  std::string bytes(const std::string& name) { return read_file(folder_ / name).value(); }
  std::string recorded(const RunObserver& observer) {
    (void)record(read_scene(scene_).value(), replacing(folder_ / "other.rbn"), observer).value();
    return bytes("other.rbn");
  }

  std::filesystem::path scene_;
};

TEST_F(TyingInAPage, records_the_bytes_of_the_recorder) {
  auto tying = Tying::begin(scene_, std::nullopt, folder_ / "knot.rbn", "test").value();
  EXPECT_EQ(tying.most_frames(), 7);
  int frames = 1;
  while (tying.next().value()) ++frames;
  EXPECT_EQ(frames, 7);
  EXPECT_THAT(tying.summary(), HasSubstr("7 frames"));
  EXPECT_TRUE(bytes("knot.rbn") == recorded(goes_on));
}

TEST_F(TyingInAPage, stopped_it_leaves_a_finished_recording) {
  auto tying = Tying::begin(scene_, std::nullopt, folder_ / "knot.rbn", "test").value();
  for (int frame = 0; frame < 3; ++frame) ASSERT_TRUE(tying.next().value());
  ASSERT_TRUE(tying.stop());
  EXPECT_THAT(tying.summary(), HasSubstr("ended early"));
  EXPECT_TRUE(RecordingReader::open(folder_ / "knot.rbn")->finished());
  EXPECT_TRUE(bytes("knot.rbn") == recorded(stops_at(3)));
}

TEST_F(TyingInAPage, what_cannot_begin_is_refused) {
  const auto refused =
      Tying::begin(folder_ / "none.toml", std::nullopt, folder_ / "knot.rbn", "test");
  EXPECT_THAT(refused.error().sentence(), HasSubstr("none.toml"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "knot.rbn"));
}

}  // namespace ribbon::tying_test
