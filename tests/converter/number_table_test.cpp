#include "converter/number_table.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>

#include "files/files.h"
#include "files/flipped.h"
#include "recording/sample_recording.h"
#include "result/demanded.h"
#include "result/refusal.h"

namespace ribbon::number_table_test {

constexpr const char* titles =
    "frame,time [s],worst_strain [1],penetrating_edges [1],recovery_iterations [1],progress [1],"
    "truncated [1],pull [1],contact [1],rope_length [ribbon widths]\n";

class NumberTable : public TestInFolder {
 protected:
  // Three frames, of which the third tells how tight it is.
  void record(const RecordingHeader& header) {
    auto writer = demanded(RecordingWriter::create(recording_, header));
    for (int frame = 0; frame < 3; ++frame) {
      FrameNumbers numbers = sample_numbers(frame);
      if (!header.stages.empty()) numbers.stage = static_cast<std::uint8_t>(frame);
      if (frame == 2) numbers.tightness = TightnessNumbers{0.1F, 0.25F, 1, 0, 12.5F};
      demanded(writer.append(numbers, sample_positions(frame)));
      ends_.push_back(std::filesystem::file_size(recording_));
    }
  }

  // The second frame cannot be read any more.
  void lose_second_frame() {
    const std::string bytes = demanded(read_file(recording_));
    demanded(write_file(recording_, flipped(bytes, (ends_[0] + ends_[1]) / 2)));
  }

  // Of some of the frames.
  std::string table_of(const std::vector<int>& frames) {
    ConversionRequest request;
    request.output = folder_ / "a.csv";
    request.force = true;
    auto reader = demanded(RecordingReader::open(recording_));
    report_ = demanded(write_number_table(request, reader, frames));
    return demanded(read_file(request.output));
  }

  std::filesystem::path recording_ = folder_ / "a.rbn";
  std::vector<std::uintmax_t> ends_;  // of the frames, in the file
  ConversionReport report_;
};

TEST_F(NumberTable, one_that_is_interrupted_may_be_tried_again) {
  record(sample_header());
  ConversionRequest request;
  request.output = folder_ / "a.csv";
  request.interrupted = [] { return true; };
  auto reader = demanded(RecordingReader::open(recording_));
  const auto written = write_number_table(request, reader, {0});
  EXPECT_EQ(refusal_of(written), "interrupted; start again");
  EXPECT_TRUE(written.error().may_pass);
}

TEST_F(NumberTable, a_line_of_names_and_units_comes_before_a_line_a_frame) {
  record(sample_header());
  EXPECT_EQ(table_of({1, 2}), std::string(titles) + "2,0.02,0.001,1,2,,,,,\n" +
                                  "3,0.04,0.002,2,4,0.1,0.25,1,0,12.5\n");
  EXPECT_EQ(report_.frames_written, 2);
  EXPECT_EQ(report_.bytes_written, demanded(read_file(report_.first_file)).size());
}

TEST_F(NumberTable, numbers_that_are_lost_leave_empty_cells_and_are_listed) {
  record(sample_header());
  lose_second_frame();
  EXPECT_EQ(table_of({0, 1}), std::string(titles) + "1,0,0,0,0,,,,,\n2,,,,,,,,,\n");
  EXPECT_THAT(report_.missing, testing::ElementsAre(2));
}

TEST_F(NumberTable, where_there_are_stages_the_last_column_names_the_frames) {
  RecordingHeader header = sample_header();
  header.stages = {"tie", R"(pull, "hard")"};
  record(header);
  const std::string table = table_of({0, 1, 2});
  EXPECT_THAT(table, testing::HasSubstr(",rope_length [ribbon widths],stage\n"));
  EXPECT_THAT(table, testing::HasSubstr("\n1,0,0,0,0,,,,,,\"\"\n"));
  EXPECT_THAT(table, testing::HasSubstr("\n2,0.02,0.001,1,2,,,,,,\"tie\"\n"));
  EXPECT_THAT(table, testing::HasSubstr(",12.5,\"pull, \"\"hard\"\"\"\n"));
  lose_second_frame();
  EXPECT_THAT(table_of({0, 1}), testing::EndsWith("\n2,,,,,,,,,,\n"));
}

}  // namespace ribbon::number_table_test
