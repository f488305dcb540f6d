// Decodes any frame of a recording, with the frames that it needs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_set>
#include <vector>

#include "playback/recording_contents.h"
#include "recording/codec/position_decoder.h"
#include "recording/codec/quantised_frame.h"

namespace ribbon {

class FrameDecoder {
 public:
  // Of one recording, whose contents all calls are to get.
  explicit FrameDecoder(const RecordingHeader& header) : decoder_(codec_parameters(header)) {}

  // Are the frame and all that it needs there? What the contents say, and what decode() found out.
  bool is_readable(RecordingContents& contents, std::uint32_t frame);

  // Nothing where the frame cannot be decoded. Decodes only what is not at hand from earlier calls.
  // Valid until the next call.
  const QuantisedFrame* decode(RecordingContents& contents, std::uint32_t frame);

 private:
  struct Slot {
    std::uint32_t frame = 0;
    std::size_t needs = 0;  // so many others, references of references
    std::uint64_t last_use = 0;
    QuantisedFrame quantised;
  };

  std::optional<std::vector<std::uint32_t>> needed(RecordingContents& contents, std::uint32_t frame,
                                                   bool all);
  Slot* at_hand(std::uint32_t frame);
  Slot& free_slot();
  bool decode_one(RecordingContents& contents, std::uint32_t frame);
  bool decode_record(const RecordingContents& contents, const IndexedFrame& entry, Slot& slot);

  PositionDecoder decoder_;
  std::vector<std::unique_ptr<Slot>> slots_;  // decoded frames
  std::uint64_t uses_ = 0;                    // a clock for last_use
  std::unordered_set<std::uint32_t> undecodable_;
};

}  // namespace ribbon
