#include "recording/records/index_record.h"

#include <gtest/gtest.h>

#include <string>

#include "recording/coding/bytes.h"
#include "recording/coding/table.h"
#include "recording/sample_recording.h"

namespace ribbon::index_record_test {

constexpr std::uint32_t id = 0x1234;
constexpr std::uint64_t here = 1450;  // where the index record itself begins

IndexedFrame indexed(std::uint32_t frame, std::uint64_t offset, std::uint32_t record_bytes) {
  return {frame, record_bytes, offset, {}, sample_numbers(static_cast<int>(frame))};
}

// Frame 8 comes before those that it is used for; 50 bytes of something else lie before frame 7.
Index index() {
  Index index{40, {}, {}};
  index.frames = {indexed(4, 1000, 200), indexed(8, 1200, 100), indexed(7, 1350, 100)};
  index.frames[1].reference = 4;
  index.frames[2].reference = 8;
  index.frames[2].numbers.tightness = TightnessNumbers{1, 2, 3, 4, 5};
  index.frames[1].numbers.stage = 3;
  index.others = {{RecordType::checkpoint, 8, 1300, 50}, {RecordType::session, 9, 900, 64}};
  return index;
}

TEST(IndexRecord, everything_comes_back) {
  EXPECT_EQ(parse_index_payload(index_payload(id, index()), id, here, here), index());
}

TEST(IndexRecord, columns_that_later_versions_append_are_ignored) {
  std::string payload = index_payload(id, index());
  ByteTaker taker(std::string_view(payload).substr(16));
  const std::string table(*take_columns(taker, 3, 66));
  const std::string rest(taker.rest());
  for (const bool is_whole : {true, false}) {
    payload.resize(16);
    put_string(payload, Compressor().compress(table + std::string(is_whole ? 6 : 5, 'x')));
    payload += rest;
    const auto read = parse_index_payload(payload, id, here, here);
    EXPECT_EQ(read.has_value(), is_whole);
    if (is_whole) {
      EXPECT_EQ(read, index());
    }
  }
}

TEST(IndexRecord, one_of_another_recording_is_refused) {
  EXPECT_FALSE(parse_index_payload(index_payload(id, index()), id + 1, here, here).has_value());
}

TEST(IndexRecord, what_does_not_lie_before_it_is_refused) {
  EXPECT_FALSE(parse_index_payload(index_payload(id, index()), id, here - 1, here).has_value());
  Index far = index();
  far.others[0].record_bytes = 151;
  EXPECT_FALSE(parse_index_payload(index_payload(id, far), id, here, here).has_value());
  far = index();
  far.frames[0].offset = 0xFFFFFFFFFFFFFFFF;
  EXPECT_FALSE(parse_index_payload(index_payload(id, far), id, here, here).has_value());
}

TEST(IndexRecord, frames_whose_records_are_smaller_than_any_are_refused) {
  for (const std::uint64_t less : {0, 1}) {
    Index small = index();
    small.frames[1].record_bytes = static_cast<std::uint32_t>(smallest_frame_record - less);
    EXPECT_EQ(parse_index_payload(index_payload(id, small), id, here, here).has_value(), less == 0);
  }
}

TEST(IndexRecord, frame_numbers_that_the_file_cannot_hold_are_refused) {
  Index far = index();
  far.frames[1].frame = static_cast<std::uint32_t>(most_frames(here));
  EXPECT_FALSE(parse_index_payload(index_payload(id, far), id, here, here).has_value());
  far.frames[1].frame -= 1;
  EXPECT_TRUE(parse_index_payload(index_payload(id, far), id, here, here).has_value());
  EXPECT_FALSE(parse_index_payload(index_payload(id, far), id, here, here - 64).has_value());
  far.others[0].frame = far.frames[1].frame + 1;
  EXPECT_TRUE(parse_index_payload(index_payload(id, far), id, here, here).has_value());
  far.others[0].frame += 1;
  EXPECT_FALSE(parse_index_payload(index_payload(id, far), id, here, here).has_value());
}

TEST(IndexRecord, a_count_that_the_file_cannot_hold_is_refused) {
  for (const char* count : {"\xFF\xFF\xFF\xFF", "\x04\0\0\0", "\x02\0\0\0"}) {
    std::string payload = index_payload(id, index());
    payload.replace(12, 4, std::string(count, 4));
    EXPECT_FALSE(parse_index_payload(payload, id, here, here).has_value());
  }
}

// Most of what lies before it is a hole.
TEST(IndexRecord, more_rows_than_what_was_written_can_hold_are_refused) {
  const std::string payload = index_payload(id, index());
  EXPECT_TRUE(parse_index_payload(payload, id, here, 3 * smallest_frame_record));
  EXPECT_FALSE(parse_index_payload(payload, id, here, 3 * smallest_frame_record - 1));
}

TEST(IndexRecord, frame_numbers_are_never_larger_than_an_int) {
  EXPECT_EQ(most_frames(0), 1024U);
  EXPECT_EQ(most_frames(640), 1034U);
  EXPECT_EQ(most_frames(0xFFFFFFFFFFFFFFFF), 1U << 30);
}

TEST(IndexRecord, every_prefix_is_refused) {
  const std::string payload = index_payload(id, index());
  for (std::size_t size = 0; size < payload.size(); ++size)
    EXPECT_FALSE(parse_index_payload(payload.substr(0, size), id, here, here).has_value()) << size;
}

}  // namespace ribbon::index_record_test
