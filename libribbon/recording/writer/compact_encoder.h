// Decoded frames to as few bytes as can be, without hurry.
#pragma once

#include <cstdint>
#include <functional>

#include "recording/codec/position_encoder.h"
#include "recording/records/reference_list.h"

namespace ribbon {

struct CompactedFrame {
  EncodedFrame encoded;
  ReferenceList references;  // that it needs, of those that were planned
};

class CompactEncoder {
 public:
  using Decoded = std::function<const QuantisedFrame*(std::uint32_t frame)>;

  CompactEncoder(const CodecParameters& parameters, double max_error_m)
      : encoder_(parameters, max_error_m) {}

  // A decoded frame once more, to the same bits, in the smallest of several ways. planned: as of
  // compaction_plan(); decoded: points to each of them.
  CompactedFrame encode(const QuantisedFrame& frame, const ReferenceList& planned,
                        const Decoded& decoded);

 private:
  struct Way;
  Way smallest(const QuantisedFrame& frame, const ReferenceList& planned, const Decoded& decoded);
  EncodedFrame encode(const QuantisedFrame& frame, const Way& way, const Decoded& decoded, Fit fit);

  PositionEncoder encoder_;
};

}  // namespace ribbon
