#include "recording/records/checkpoint_record.h"

#include <gtest/gtest.h>

#include "files/flipped.h"

namespace ribbon::checkpoint_record_test {

constexpr std::uint32_t id = 0x1234;
constexpr RibbonGrid grid{3, 2};

std::string state() {
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes.push_back(static_cast<char>(i * i % 251));
  return bytes;
}

TEST(CheckpointRecord, everything_comes_back) {
  for (const std::string& written : {std::string(), state()}) {
    const std::string payload = checkpoint_payload(id, 17, 0x123456789A, written);
    const auto read = parse_checkpoint_payload(payload, id, grid).value();
    EXPECT_EQ(read.frame, 17U);
    EXPECT_EQ(read.steps, 0x123456789AU);
    EXPECT_TRUE(read.state == written);
    EXPECT_EQ(parse_checkpoint_fields(payload)->frame, 17U);
  }
}

TEST(CheckpointRecord, one_of_another_recording_is_refused) {
  EXPECT_FALSE(parse_checkpoint_payload(checkpoint_payload(id, 17, 3, "x"), id + 1, grid));
}

TEST(CheckpointRecord, every_prefix_is_refused) {
  const std::string payload = checkpoint_payload(id, 17, 3, state());
  for (std::size_t size = 0; size < payload.size(); ++size)
    EXPECT_FALSE(parse_checkpoint_payload(payload.substr(0, size), id, grid).has_value()) << size;
}

// Frame and steps have only the record's checksum.
TEST(CheckpointRecord, a_state_is_never_passed_as_right_that_is_not) {
  const std::string payload = checkpoint_payload(id, 17, 3, state());
  for (std::size_t at = 16; at < payload.size(); ++at) {
    const auto read = parse_checkpoint_payload(flipped(payload, at, 0x11), id, grid);
    EXPECT_TRUE(!read || read->state == state()) << at;
  }
}

TEST(CheckpointRecord, what_a_newer_minor_version_puts_before_the_state_is_ignored) {
  std::string payload = checkpoint_payload(id, 17, 3, state());
  payload.insert(32, "news");
  payload[28] = 36;
  EXPECT_TRUE(parse_checkpoint_payload(payload, id, grid).value().state == state());
}

TEST(CheckpointRecord, a_state_larger_than_any_is_refused_before_it_is_unpacked) {
  const std::string zeros(largest_state_bytes(grid) + 1, '\0');
  EXPECT_FALSE(parse_checkpoint_payload(checkpoint_payload(id, 1, 1, zeros), id, grid));
  EXPECT_TRUE(parse_checkpoint_payload(
      checkpoint_payload(id, 1, 1, std::string_view(zeros).substr(1)), id, grid));
}

}  // namespace ribbon::checkpoint_record_test
