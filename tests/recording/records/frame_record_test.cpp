#include "recording/records/frame_record.h"

#include <gtest/gtest.h>

#include "recording/sample_recording.h"

namespace ribbon::frame_record_test {

FrameRecord record(std::size_t references, bool tightness) {
  FrameRecord frame{.recording_id = 0x1234,
                    .frame = 300,
                    .encoding = FrameEncoding::quantised,
                    .numbers = sample_numbers(7),
                    .geometry = "geometry"};
  for (std::size_t k = 0; k < references; ++k)
    frame.references.push_back(static_cast<std::uint32_t>(299 - 10 * k));
  if (tightness) frame.numbers.tightness = TightnessNumbers{1, 2, 3, 4, 5};
  return frame;
}

TEST(FrameRecord, everything_comes_back) {
  for (std::size_t references = 0; references <= most_references; ++references)
    for (const bool tightness : {false, true}) {
      FrameRecord written = record(references, tightness);
      written.numbers.stage = static_cast<std::uint8_t>(references);
      const std::string payload = frame_payload(written);
      EXPECT_EQ(parse_frame_payload(payload), written);
    }
}

TEST(FrameRecord, what_a_newer_minor_version_puts_before_the_geometry_is_ignored) {
  std::string payload = frame_payload(record(2, true));
  payload.insert(payload.size() - 8, "news");
  payload[8] = static_cast<char>(payload[8] + 4);
  payload[15] = 1;  // a flag that nobody knows yet
  const auto read = parse_frame_payload(payload).value();
  EXPECT_EQ(read.geometry, "geometry");
  EXPECT_EQ(read.numbers, record(2, true).numbers);
}

TEST(FrameRecord, every_prefix_of_its_fields_is_refused) {
  FrameRecord record_in_stage = record(2, true);
  record_in_stage.numbers.stage = 255;
  const std::string payload = frame_payload(record_in_stage);
  for (std::size_t size = 0; size < payload.size() - 8; ++size)
    EXPECT_FALSE(parse_frame_payload(payload.substr(0, size)).has_value()) << size;
}

TEST(FrameRecord, what_cannot_be_is_refused) {
  const std::string payload = frame_payload(record(1, false));
  const auto with = [&](std::size_t at, char value) {
    std::string changed = payload;
    changed[at] = value;
    return parse_frame_payload(changed).has_value();
  };
  EXPECT_TRUE(with(0, 0));
  EXPECT_FALSE(with(8, 43)) << "the geometry begins inside the references";
  EXPECT_FALSE(with(9, 1)) << "the geometry begins behind the payload";
  EXPECT_FALSE(with(10, 2)) << "no such encoding";
  EXPECT_FALSE(with(11, 3)) << "too many references";
}

}  // namespace ribbon::frame_record_test
