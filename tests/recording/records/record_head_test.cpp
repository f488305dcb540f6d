#include "recording/records/record_head.h"

#include <gtest/gtest.h>

#include "files/flipped.h"
#include "recording/coding/checksum.h"

namespace ribbon::record_head_test {

TEST(Checksum, it_is_the_crc_32_of_zlib) {
  EXPECT_EQ(checksum("123456789"), 0xCBF43926U);  // the check value of the CRC catalogue
  EXPECT_EQ(checksum(""), 0U);
}

TEST(Record, a_head_tells_type_length_and_checksum) {
  const std::string record = make_record(RecordType::frame, "payload");
  ASSERT_EQ(record.size(), record_head_bytes + 7);
  EXPECT_EQ(record.substr(0, 4), "\xB1REC");
  EXPECT_EQ(record.substr(record_head_bytes), "payload");
  const auto head = parse_record_head(record).value();
  EXPECT_EQ(head.type, RecordType::frame);
  EXPECT_EQ(head.payload_bytes, 7U);
  EXPECT_EQ(head.payload_checksum, checksum("payload"));
}

TEST(Record, every_flipped_byte_of_a_head_is_noticed) {
  const std::string record = make_record(RecordType::index, "payload");
  for (std::size_t at = 0; at < record_head_bytes; ++at)
    EXPECT_FALSE(parse_record_head(flipped(record, at, 0x10)).has_value()) << "byte " << at;
}

TEST(Record, a_cut_head_is_no_head) {
  const std::string record = make_record(RecordType::frame, "");
  for (std::size_t size = 0; size < record_head_bytes; ++size)
    EXPECT_FALSE(parse_record_head(std::string_view(record).substr(0, size)).has_value());
}

TEST(Record, an_unknown_type_has_a_valid_head) {
  const auto head = parse_record_head(make_record(static_cast<RecordType>(77), "new")).value();
  EXPECT_EQ(static_cast<int>(head.type), 77);
}

}  // namespace ribbon::record_head_test
