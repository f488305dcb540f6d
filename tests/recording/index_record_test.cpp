#include "recording/index_record.h"

#include <gtest/gtest.h>

#include "recording/sample_recording.h"

namespace ribbon {
namespace {

constexpr std::uint32_t id = 0x1234;
constexpr std::uint64_t frames_begin = 1000;

Index index() {
  return {{{1000, 200, 0, sample_numbers(0)},
           {1200, 100, 1, sample_numbers(1)},
           {1350, 100, 2, sample_numbers(2)}},  // 50 bytes of something else before it
          RunEnding::stopped};
}

// Every measure another number.
TightnessNumbers tightness(float first) {
  return {first, first + 1, first + 2, first + 3, first + 4};
}

TEST(IndexRecord, entries_come_back) {
  const auto read =
      parse_index_payload(index_payload(id, index(), frames_begin), id, frames_begin, 1450);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->ending, RunEnding::stopped);
  ASSERT_EQ(read->entries.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read->entries[i].offset, index().entries[i].offset);
    EXPECT_EQ(read->entries[i].record_bytes, index().entries[i].record_bytes);
    EXPECT_EQ(read->entries[i].frames_since_key, index().entries[i].frames_since_key);
    EXPECT_EQ(read->entries[i].numbers, index().entries[i].numbers);
  }
}

TEST(IndexRecord, tightness_comes_back) {
  Index tightened = index();
  for (std::size_t i = 0; i < 3; ++i)
    tightened.entries[i].numbers.tightness = tightness(10.0F * static_cast<float>(i));
  const std::string payload = index_payload(id, tightened, frames_begin);
  const auto read = parse_index_payload(payload, id, frames_begin, 1450);
  ASSERT_TRUE(read.has_value());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(read->entries[i].numbers, tightened.entries[i].numbers);
  for (std::size_t size = payload.size() - 4; size < payload.size(); ++size)
    EXPECT_FALSE(parse_index_payload(payload.substr(0, size), id, frames_begin, 1450).has_value());
}

TEST(IndexRecord, an_index_of_version_1_1_tells_no_ending) {
  std::string payload = index_payload(id, index(), frames_begin);
  payload.resize(payload.size() - 2);
  const auto read = parse_index_payload(payload, id, frames_begin, 1450);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->ending, RunEnding::unknown);
  EXPECT_FALSE(read->entries[0].numbers.tightness.has_value());
}

TEST(IndexRecord, an_ending_of_a_later_version_is_none) {
  std::string payload = index_payload(id, index(), frames_begin);
  payload[payload.size() - 2] = 17;
  EXPECT_EQ(parse_index_payload(payload, id, frames_begin, 1450)->ending, RunEnding::unknown);
}

TEST(IndexRecord, an_index_of_another_recording_is_refused) {
  const std::string payload = index_payload(id, index(), frames_begin);
  EXPECT_FALSE(parse_index_payload(payload, id + 1, frames_begin, 1450).has_value());
}

TEST(IndexRecord, frames_beyond_their_room_are_refused) {
  const std::string payload = index_payload(id, index(), frames_begin);
  EXPECT_FALSE(parse_index_payload(payload, id, frames_begin, 1449).has_value());
}

TEST(IndexRecord, a_count_that_the_file_cannot_hold_is_refused) {
  std::string payload = index_payload(id, index(), frames_begin);
  payload.replace(4, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_FALSE(parse_index_payload(payload, id, frames_begin, 1450).has_value());
  payload.replace(4, 4, std::string("\x04\0\0\0", 4));
  EXPECT_FALSE(parse_index_payload(payload, id, frames_begin, 1450).has_value());
}

TEST(IndexRecord, every_prefix_is_refused_but_that_of_an_older_version) {
  const std::string payload = index_payload(id, index(), frames_begin);
  for (std::size_t size = 0; size < payload.size(); ++size)
    EXPECT_EQ(parse_index_payload(payload.substr(0, size), id, frames_begin, 1450).has_value(),
              size + 2 == payload.size());
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
