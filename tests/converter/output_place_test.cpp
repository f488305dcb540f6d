#include "converter/output_place.h"

#include <gtest/gtest.h>

#include <mutex>

#include "converter/conversion.h"
#include "files/files.h"
#include "files/temporary_folder.h"
#include "model/sample_knot.h"
#include "recording/sample_recording.h"
#include "result/refusal.h"

namespace ribbon::output_place_test {

class OutputPlace : public TestInFolder {
 protected:
  OutputPlace() {
    const SampleKnot knot = sample_knot();
    write_recording(folder_ / "knot.rbn", knot.header, knot.frames);
  }

  // Somebody else writes `file` meanwhile.
  [[nodiscard]] Result<ConversionReport> convert_beside(const std::string& output,
                                                        const std::string& file,
                                                        bool force = false) const {
    std::once_flag written;
    ConversionRequest request;
    request.recording = folder_ / "knot.rbn";
    request.output = folder_ / output;
    request.force = force;
    request.progress = ProgressStyle::none;
    request.interrupted = [&] {
      std::call_once(written, [&] { EXPECT_TRUE(write_file(folder_ / file, "mine")); });
      return false;
    };
    return convert(request);
  }
};

TEST_F(OutputPlace, a_file_that_comes_in_the_meantime_is_not_replaced_unasked) {
  const std::vector<std::pair<std::string, std::string>> files{{"a.abc", "a.abc"},
                                                               {"a.fbx", "a.fbx"},
                                                               {"a.glb", "a.glb"},
                                                               {"a.mdd", "a.mdd"},
                                                               {"b.mdd", "b.obj"},
                                                               {"c.mdd", "c.mtl"},
                                                               {"a.npy", "a.npy"},
                                                               {"d.pc2", "d.pc2"},
                                                               {"a.usda", "a.usda"},
                                                               {"a.csv", "a.csv"},
                                                               {"a.rbn", "a.rbn"},
                                                               {"e.{frame}.obj", "e.0005.obj"},
                                                               {"f.{frame}.fbx", "f.0005.fbx"}};
  for (const auto& [output, file] : files) {
    EXPECT_THAT(refusal_of(convert_beside(output, file)), HasSubstr(file + ": was put there"))
        << output;
    EXPECT_EQ(read_file(folder_ / file), "mine") << output;
    EXPECT_TRUE(convert_beside(output, file, true)) << output;
    EXPECT_NE(read_file(folder_ / file), "mine") << output;
  }
}

}  // namespace ribbon::output_place_test
