#include "recording/records/directory_record.h"

#include <gtest/gtest.h>

#include <string>

namespace ribbon::directory_record_test {

constexpr std::uint32_t id = 0x1234;
constexpr std::uint64_t here = 5000;  // where the directory record itself begins

Directory directory() {
  return {300, RunEnding::tight, {{1000, 200, 0, 256, 255, 1}, {4000, 1000, 254, 299, 45, 0}}};
}

TEST(DirectoryRecord, everything_comes_back) {
  EXPECT_EQ(parse_directory_payload(directory_payload(id, directory()), id, here, here),
            directory());
}

TEST(DirectoryRecord, every_ending_comes_back) {
  for (int number = 0; number <= 7; ++number) {
    Directory with = directory();
    with.ending = static_cast<RunEnding>(number);
    EXPECT_EQ(parse_directory_payload(directory_payload(id, with), id, here, here), with);
  }
}

TEST(DirectoryRecord, an_ending_of_a_later_version_is_none) {
  std::string payload = directory_payload(id, directory());
  payload[8] = 17;
  EXPECT_EQ(parse_directory_payload(payload, id, here, here)->ending, RunEnding::unknown);
}

TEST(DirectoryRecord, one_of_another_recording_is_refused) {
  EXPECT_FALSE(parse_directory_payload(directory_payload(id, directory()), id + 1, here, here));
}

TEST(DirectoryRecord, indices_that_do_not_lie_before_it_are_refused) {
  EXPECT_FALSE(parse_directory_payload(directory_payload(id, directory()), id, here - 1, here));
}

TEST(DirectoryRecord, frames_that_the_file_cannot_hold_are_refused) {
  Directory large = directory();
  large.frames = static_cast<std::uint32_t>(most_frames(here)) + 1;
  EXPECT_FALSE(parse_directory_payload(directory_payload(id, large), id, here, here));
  large.frames -= 1;
  EXPECT_TRUE(parse_directory_payload(directory_payload(id, large), id, here, here));
  EXPECT_FALSE(parse_directory_payload(directory_payload(id, large), id, here, here - 64));
}

TEST(DirectoryRecord, more_indices_than_what_was_written_can_hold_are_refused) {
  const std::string payload = directory_payload(id, directory());
  EXPECT_TRUE(parse_directory_payload(payload, id, here, 2 * record_head_bytes));
  EXPECT_FALSE(parse_directory_payload(payload, id, here, 2 * record_head_bytes - 1));
}

TEST(DirectoryRecord, fewer_frames_than_the_indices_have_are_refused) {
  Directory small = directory();
  small.frames = 299;
  EXPECT_FALSE(parse_directory_payload(directory_payload(id, small), id, here, here));
}

TEST(DirectoryRecord, an_index_whose_frames_end_before_they_begin_is_refused) {
  Directory turned = directory();
  turned.indices[0].lowest_frame = 257;
  EXPECT_FALSE(parse_directory_payload(directory_payload(id, turned), id, here, here));
}

TEST(DirectoryRecord, every_prefix_is_refused) {
  const std::string payload = directory_payload(id, directory());
  for (std::size_t size = 0; size < payload.size(); ++size)
    EXPECT_FALSE(parse_directory_payload(payload.substr(0, size), id, here, here).has_value())
        << size;
}

TEST(FooterRecord, it_names_the_directory) {
  const std::string payload = footer_payload(id, 0x123456789A);
  EXPECT_EQ(payload.size(), footer_payload_bytes);
  EXPECT_EQ(parse_footer_payload(payload, id), 0x123456789AU);
  EXPECT_FALSE(parse_footer_payload(payload, id + 1).has_value());
  EXPECT_FALSE(parse_footer_payload(payload.substr(0, 15), id).has_value());
}

}  // namespace ribbon::directory_record_test
