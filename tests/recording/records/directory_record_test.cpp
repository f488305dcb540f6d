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
  EXPECT_EQ(parse_directory_payload(directory_payload(id, directory()), id, here), directory());
}

TEST(DirectoryRecord, an_ending_of_a_later_version_is_none) {
  std::string payload = directory_payload(id, directory());
  payload[8] = 17;
  EXPECT_EQ(parse_directory_payload(payload, id, here)->ending, RunEnding::unknown);
}

TEST(DirectoryRecord, one_of_another_recording_is_refused) {
  EXPECT_FALSE(parse_directory_payload(directory_payload(id, directory()), id + 1, here));
}

TEST(DirectoryRecord, indices_that_do_not_lie_before_it_are_refused) {
  EXPECT_FALSE(parse_directory_payload(directory_payload(id, directory()), id, here - 1));
}

TEST(DirectoryRecord, frames_that_the_file_cannot_hold_are_refused) {
  Directory large = directory();
  large.frames = static_cast<std::uint32_t>(most_frames(here)) + 1;
  EXPECT_FALSE(parse_directory_payload(directory_payload(id, large), id, here));
}

TEST(DirectoryRecord, fewer_frames_than_the_indices_have_are_refused) {
  Directory small = directory();
  small.frames = 299;
  EXPECT_FALSE(parse_directory_payload(directory_payload(id, small), id, here));
}

TEST(DirectoryRecord, every_prefix_is_refused) {
  const std::string payload = directory_payload(id, directory());
  for (std::size_t size = 0; size < payload.size(); ++size)
    EXPECT_FALSE(parse_directory_payload(payload.substr(0, size), id, here).has_value()) << size;
}

TEST(FooterRecord, it_names_the_directory) {
  const std::string payload = footer_payload(id, 0x123456789A);
  EXPECT_EQ(payload.size(), footer_payload_bytes);
  EXPECT_EQ(parse_footer_payload(payload, id), 0x123456789AU);
  EXPECT_FALSE(parse_footer_payload(payload, id + 1).has_value());
  EXPECT_FALSE(parse_footer_payload(payload.substr(0, 15), id).has_value());
}

}  // namespace ribbon::directory_record_test
