#include "recording/records/frame_record.h"

#include <gtest/gtest.h>

#include "recording/sample_recording.h"

namespace ribbon::frame_record_test {

FrameRecord record(bool has_reference, bool tightness) {
  FrameRecord frame{.recording_id = 0x1234,
                    .frame = 300,
                    .encoding = FrameEncoding::quantised,
                    .numbers = sample_numbers(7),
                    .geometry = "geometry"};
  if (has_reference) frame.reference = 299;
  if (tightness) frame.numbers.tightness = TightnessNumbers{1, 2, 3, 4, 5};
  return frame;
}

TEST(FrameRecord, everything_comes_back) {
  for (const bool has_reference : {false, true})
    for (const bool tightness : {false, true}) {
      FrameRecord written = record(has_reference, tightness);
      written.numbers.stage = has_reference ? 2 : 0;
      const std::string payload = frame_payload(written);
      EXPECT_EQ(parse_frame_payload(payload), written);
    }
}

TEST(FrameRecord, what_a_newer_minor_version_puts_before_the_geometry_is_ignored) {
  std::string payload = frame_payload(record(true, true));
  payload.insert(payload.size() - 8, "news");
  payload[8] = static_cast<char>(payload[8] + 4);
  payload[15] = 1;  // a flag that nobody knows yet
  const auto read = parse_frame_payload(payload).value();
  EXPECT_EQ(read.geometry, "geometry");
  EXPECT_EQ(read.numbers, record(true, true).numbers);
}

TEST(FrameRecord, every_prefix_of_its_fields_is_refused) {
  FrameRecord record_in_stage = record(true, true);
  record_in_stage.numbers.stage = 255;
  const std::string payload = frame_payload(record_in_stage);
  for (std::size_t size = 0; size < payload.size() - 8; ++size)
    EXPECT_FALSE(parse_frame_payload(payload.substr(0, size)).has_value()) << size;
}

TEST(FrameRecord, what_cannot_be_is_refused) {
  const std::string payload = frame_payload(record(true, false));
  const auto with = [&](std::size_t at, char value) {
    std::string changed = payload;
    changed[at] = value;
    return parse_frame_payload(changed).has_value();
  };
  EXPECT_TRUE(with(0, 0));
  EXPECT_FALSE(with(8, 43)) << "the geometry begins inside the reference";
  EXPECT_TRUE(with(8, static_cast<char>(payload.size()))) << "no geometry";
  EXPECT_FALSE(with(8, static_cast<char>(payload.size() + 1)));
  EXPECT_FALSE(with(9, 1)) << "the geometry begins behind the payload";
  EXPECT_FALSE(with(10, 2)) << "no such encoding";
  EXPECT_FALSE(with(11, 1)) << "no such encoding";
}

}  // namespace ribbon::frame_record_test
