#include "converter/number_table.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "recording/sample_recording.h"
#include "result/demanded.h"
#include "result/refusal.h"

namespace ribbon::number_table_test {

constexpr const char* titles =
    "frame,time [s],worst_strain [1],penetrating_edges [1],recovery_iterations [1],progress [1],"
    "truncated [1],pull [1],contact [1],rope_length [ribbon widths]\n";

class NumberTable : public TestInFolder {
 protected:
  // The table of the second and third of three frames, of which the third tells how tight it is.
  std::string table_of(const std::vector<int>& frames,
                       const RecordingHeader& header = sample_header()) {
    const auto recording = folder_ / "a.rbn";
    auto writer = demanded(RecordingWriter::create(recording, header));
    for (int frame = 0; frame < 3; ++frame) {
      FrameNumbers numbers = sample_numbers(frame);
      if (!header.stages.empty()) numbers.stage = static_cast<std::uint8_t>(frame);
      if (frame == 2) numbers.tightness = TightnessNumbers{0.1F, 0.25F, 1, 0, 12.5F};
      demanded(writer.append(numbers, sample_positions(frame)));
    }
    demanded(writer.finish());
    ConversionRequest request;
    request.output = folder_ / "a.csv";
    const auto reader = demanded(RecordingReader::open(recording));
    report_ = demanded(write_number_table(request, reader, frames));
    return demanded(read_file(request.output));
  }

  ConversionReport report_;
};

TEST_F(NumberTable, a_line_of_names_and_units_comes_before_a_line_a_frame) {
  EXPECT_EQ(table_of({1, 2}), std::string(titles) + "2,0.02,0.001,1,2,,,,,\n" +
                                  "3,0.04,0.002,2,4,0.1,0.25,1,0,12.5\n");
  EXPECT_EQ(report_.frames_written, 2);
  EXPECT_EQ(report_.bytes_written, demanded(read_file(report_.first_file)).size());
}

TEST_F(NumberTable, numbers_that_are_lost_leave_empty_cells_and_are_listed) {
  EXPECT_EQ(table_of({0, 7}), std::string(titles) + "1,0,0,0,0,,,,,\n8,,,,,,,,,\n");
  EXPECT_THAT(report_.missing, testing::ElementsAre(8));
}

TEST_F(NumberTable, where_there_are_stages_the_last_column_names_the_frames) {
  RecordingHeader header = sample_header();
  header.stages = {"tie", R"(pull, "hard")"};
  const std::string table = table_of({0, 1, 2, 7}, header);
  EXPECT_THAT(table, testing::HasSubstr(",rope_length [ribbon widths],stage\n"));
  EXPECT_THAT(table, testing::HasSubstr("\n1,0,0,0,0,,,,,,\"\"\n"));
  EXPECT_THAT(table, testing::HasSubstr("\n2,0.02,0.001,1,2,,,,,,\"tie\"\n"));
  EXPECT_THAT(table, testing::HasSubstr(",12.5,\"pull, \"\"hard\"\"\"\n"));
  EXPECT_THAT(table, testing::EndsWith("\n8,,,,,,,,,,\n"));
}

}  // namespace ribbon::number_table_test
