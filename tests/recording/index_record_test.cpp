#include "recording/index_record.h"

#include <gtest/gtest.h>

#include "recording/sample_recording.h"

namespace ribbon {
namespace {

constexpr std::uint32_t id = 0x1234;
constexpr std::uint64_t frames_begin = 1000;

std::vector<IndexEntry> entries() {
  return {{1000, 200, 0, sample_numbers(0)},
          {1200, 100, 1, sample_numbers(1)},
          {1350, 100, 2, sample_numbers(2)}};  // 50 bytes of something else before it
}

TEST(IndexRecord, entries_come_back) {
  const auto read =
      parse_index_payload(index_payload(id, entries(), frames_begin), id, frames_begin, 1450);
  ASSERT_TRUE(read.has_value());
  ASSERT_EQ(read->size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ((*read)[i].offset, entries()[i].offset);
    EXPECT_EQ((*read)[i].record_bytes, entries()[i].record_bytes);
    EXPECT_EQ((*read)[i].frames_since_key, entries()[i].frames_since_key);
    EXPECT_EQ((*read)[i].numbers, entries()[i].numbers);
  }
}

TEST(IndexRecord, an_index_of_another_recording_is_refused) {
  const std::string payload = index_payload(id, entries(), frames_begin);
  EXPECT_FALSE(parse_index_payload(payload, id + 1, frames_begin, 1450).has_value());
}

TEST(IndexRecord, frames_beyond_their_room_are_refused) {
  const std::string payload = index_payload(id, entries(), frames_begin);
  EXPECT_FALSE(parse_index_payload(payload, id, frames_begin, 1449).has_value());
}

TEST(IndexRecord, a_count_that_the_file_cannot_hold_is_refused) {
  std::string payload = index_payload(id, entries(), frames_begin);
  payload.replace(4, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_FALSE(parse_index_payload(payload, id, frames_begin, 1450).has_value());
  payload.replace(4, 4, std::string("\x04\0\0\0", 4));
  EXPECT_FALSE(parse_index_payload(payload, id, frames_begin, 1450).has_value());
}

TEST(IndexRecord, every_prefix_is_refused) {
  const std::string payload = index_payload(id, entries(), frames_begin);
  for (std::size_t size = 0; size < payload.size(); ++size)
    EXPECT_FALSE(parse_index_payload(payload.substr(0, size), id, frames_begin, 1450).has_value());
}

TEST(IndexRecord, the_footer_names_the_index) {
  const std::string payload = footer_payload(id, 0x123456789A);
  EXPECT_EQ(payload.size(), footer_payload_bytes);
  EXPECT_EQ(parse_footer_payload(payload, id), 0x123456789AU);
  EXPECT_FALSE(parse_footer_payload(payload, id + 1).has_value());
  EXPECT_FALSE(parse_footer_payload(payload.substr(0, 15), id).has_value());
}

}  // namespace
}  // namespace ribbon
