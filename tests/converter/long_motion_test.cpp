// What conversions of many frames take.
#include <gtest/gtest.h>

#include <filesystem>

#include "commandline/tool_run.h"
#include "converter/motion_format.h"
#include "model/sample_knot.h"
#include "recorder/process.h"
#include "recording/writer/recording_writer.h"
#include "result/demanded.h"

namespace ribbon::long_motion_test {

namespace fs = std::filesystem;

// Sanitizers keep books, and what was given back, in the same memory.
#if defined(__has_feature)
constexpr bool memory_is_measurable = !__has_feature(address_sanitizer);
#else
constexpr bool memory_is_measurable = true;
#endif

constexpr RibbonGrid grid{.along = 60, .across = 8};
constexpr double bytes_of_positions = 60 * 8 * 12;

class LongMotion : public TestInFolder {
 protected:
  // Bytes that a conversion with reading back takes at most.
  [[nodiscard]] double peak_of(int frames, const std::string& extension) const {
    const fs::path recording = folder_ / (std::to_string(frames) + ".rbn");
    if (!fs::exists(recording)) record(recording, frames);
    const Ended ended = end_of(spawned(
        {RIBBON_CONVERT, recording, "-o", folder_ / (std::to_string(frames) + "." + extension),
         "--object", "ribbon", "--verify", "--quiet", "--force"},
        StandardOutput::thrown_away));
    EXPECT_EQ(ended.exit_code, 0);
    return ended.most_memory;
  }

 private:
  static void record(const fs::path& recording, int frames) {
    auto writer = demanded(
        RecordingWriter::create(recording, sample_knot({.along = 60, .across = 8}).header));
    for (int frame = 0; frame < frames; ++frame)
      demanded(writer.append({.time_s = 0.02 * frame}, sample_wave(grid, 0.01 * (frame % 100))));
    demanded(writer.finish());
  }
};

// But for what the format has to say of each frame in one place, and where it lies.
TEST_F(LongMotion, memory_hardly_grows_with_the_number_of_frames) {
  if (!memory_is_measurable) GTEST_SKIP() << "memory is not measured under sanitizers";
  constexpr int few = 100;
  constexpr int many = 1600;
  for (const MotionFormat& format : motion_formats()) {
    const std::string extension(format.extension.substr(1));
    const double grown = peak_of(many, extension) - peak_of(few, extension);
    EXPECT_LT(grown / (many - few), bytes_of_positions / 2) << extension;
  }
}

}  // namespace ribbon::long_motion_test
