#include "converter/expected_size.h"

#include <gtest/gtest.h>

#include <cmath>

#include "converter/dry_run.h"
#include "files/files.h"
#include "files/flipped.h"
#include "files/temporary_folder.h"
#include "model/sample_knot.h"
#include "playback/recording_reader.h"
#include "recording/sample_recording.h"
#include "result/refusal.h"

namespace ribbon::expected_size_test {

class ExpectedSizeTest : public TestInFolder {
 protected:
  // A wave that grows, so that frames differ in size where a format compresses them.
  void record(int frames) const {
    SampleKnot knot = sample_knot();
    knot.frames.clear();
    for (int frame = 0; frame < frames; ++frame)
      knot.frames.push_back(sample_wave(knot.header.grid, 0.02 * frame));
    write_recording(folder_ / "knot.rbn", knot.header, knot.frames);
  }

  [[nodiscard]] ConversionRequest request(const std::string& output, const std::string& frames,
                                          const ModelSettings& model = {}) const {
    return {.recording = folder_ / "knot.rbn",
            .output = folder_ / output,
            .frames = frames,
            .model = model,
            .start_frame = std::nullopt,
            .force = true,
            .progress = ProgressStyle::none};
  }

  // What a dry run and then a conversion say.
  void expect_that_size(const std::string& output, const std::string& frames = "",
                        const ModelSettings& model = {}) const {
    const ConversionRequest asked = request(output, frames, model);
    const auto plan = plan_conversion(asked);
    ASSERT_EQ(refusal_of(plan), "") << output;
    const auto written = static_cast<double>(convert(asked).value().bytes_written);
    EXPECT_LE(std::abs(plan->bytes - written), plan->margin_bytes + 0.03 * written)
        << output << ": " << plan->bytes << " instead of " << written;
    EXPECT_LE(plan->margin_bytes, 0.5 * written) << output;
  }
};

TEST_F(ExpectedSizeTest, is_that_of_the_files_in_every_format) {
  record(150);
  for (const char* output : {"a.abc", "a.fbx", "a.glb", "a.mdd", "a.npy", "a.pc2", "a.usda",
                             "a.csv", "a.{frame}.obj", "b.rbn"})
    expect_that_size(output);
  expect_that_size("c.rbn", "::3");
}

TEST_F(ExpectedSizeTest, of_few_frames_is_exact) {
  record(3);
  for (const char* frames : {"1", "1:2", "1:3"})
    for (const char* output : {"a.abc", "a.fbx", "a.glb", "a.mdd", "a.usda"})
      expect_that_size(output, frames);
}

// A byte is changed in one frame, which no directory tells.
TEST_F(ExpectedSizeTest, does_not_fail_where_a_frame_that_it_tries_is_lost) {
  record(150);
  const std::filesystem::path file = folder_ / "knot.rbn";
  const std::string whole = read_file(file).value();
  for (const char* output : {"a.abc", "a.glb", "a.{frame}.obj", "b.rbn"})
    for (const std::size_t place : {whole.size() / 10, whole.size() / 2}) {
      ASSERT_TRUE(write_file(file, flipped(whole, place)));
      auto reader = RecordingReader::open(file).value();
      reader.check();
      int first_lost = 0;
      while (reader.readable(first_lost)) ++first_lost;
      ASSERT_LT(first_lost, 150);
      const auto plan = plan_conversion(request(output, std::to_string(first_lost + 1) + ":"));
      EXPECT_EQ(refusal_of(plan), "") << output;
    }
}

// Vertices coincide in the third frame.
TEST_F(ExpectedSizeTest, does_not_try_a_frame_that_cannot_be_made_a_solid) {
  SampleKnot knot = sample_knot();
  knot.header.obstacle.reset();
  write_recording(folder_ / "knot.rbn", knot.header, knot.frames);
  for (const char* output : {"a.abc", "a.glb", "a.mdd", "a.usda"})
    expect_that_size(output, "3:5", {.thickness_m = 0.001});
  EXPECT_THAT(refusal_of(plan_conversion(request("a.usda", "3", {.thickness_m = 0.001}))),
              HasSubstr("of no frame can be made a solid"));
}

}  // namespace ribbon::expected_size_test
