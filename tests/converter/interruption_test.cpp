// Ctrl-C is asked for wherever all frames are gone through.
#include <gtest/gtest.h>

#include "converter/conversion.h"
#include "converter/dry_run.h"
#include "converter/output_verification.h"
#include "files/temporary_folder.h"
#include "model/sample_knot.h"
#include "recording/sample_recording.h"
#include "result/refusal.h"

namespace ribbon::interruption_test {

class Interruption : public TestInFolder {
 protected:
  [[nodiscard]] ConversionRequest request(const std::string& output) const {
    ConversionRequest request;
    request.recording = folder_ / "knot.rbn";
    request.output = folder_ / output;
    request.progress = ProgressStyle::none;
    return request;
  }

  void record(const SampleKnot& knot) const {
    write_recording(folder_ / "knot.rbn", knot.header, knot.frames);
  }

  SampleKnot knot_ = sample_knot();
};

template <class Value>
void expect_interrupted(const Result<Value>& answer) {
  EXPECT_THAT(refusal_of(answer), HasSubstr("interrupted"));
  EXPECT_TRUE(!answer && answer.error().may_pass);
}

TEST_F(Interruption, ends_the_search_for_a_frame_that_is_a_solid) {
  knot_.header.obstacle.reset();
  knot_.frames.assign(2, knot_.frames[2]);  // a pinched ribbon is none
  record(knot_);
  ConversionRequest asked = request("a.pc2");
  asked.model.thickness_m = 0.001;
  EXPECT_THAT(refusal_of(convert(asked)), HasSubstr("can be made a solid"));
  asked.interrupted = [] { return true; };
  expect_interrupted(convert(asked));
  expect_interrupted(verify_output(asked, std::nullopt));
  expect_interrupted(plan_conversion(asked));
}

TEST_F(Interruption, is_asked_for_while_the_reach_of_all_frames_is_found) {
  record(knot_);
  int questions = 0;
  ConversionRequest asked = request("a.rbn");
  asked.max_error_m = 10 * knot_.header.max_position_error_m;
  asked.interrupted = [&] { return ++questions > 5; };
  expect_interrupted(convert(asked));
}

}  // namespace ribbon::interruption_test
