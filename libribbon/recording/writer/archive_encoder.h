// Decoded frames to as few bytes as can be, without hurry.
#pragma once

#include <cstdint>
#include <functional>

#include "recording/codec/position_encoder.h"
#include "recording/records/reference_list.h"

namespace ribbon {

struct ArchivedFrame {
  EncodedFrame encoded;
  ReferenceList references;  // that it needs, of those that were planned
};

class ArchiveEncoder {
 public:
  using Decoded = std::function<const LatticeFrame&(std::uint32_t frame)>;

  ArchiveEncoder(const CodecParameters& parameters, double max_error_m)
      : encoder_(parameters, max_error_m) {}

  // A decoded frame once more, to the same bits, in the smallest of several ways. planned: as of
  // archive_plan(); decoded: gives each of them.
  ArchivedFrame encode(const LatticeFrame& frame, const ReferenceList& planned,
                       const Decoded& decoded);

 private:
  struct Way;
  Way smallest(const LatticeFrame& frame, const ReferenceList& planned, const Decoded& decoded);
  EncodedFrame encode(const LatticeFrame& frame, const Way& way, const Decoded& decoded, Fit fit);

  PositionEncoder encoder_;
};

}  // namespace ribbon
