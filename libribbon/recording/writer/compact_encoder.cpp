#include "recording/writer/compact_encoder.h"

#include <algorithm>

namespace ribbon {

namespace {

ReferenceList first_of(const ReferenceList& references, std::size_t count) {
  ReferenceList first;
  for (std::size_t k = 0; k < std::min(count, references.size()); ++k)
    first.push_back(references[k]);
  return first;
}

}  // namespace

// What a frame may be predicted from, and how.
struct CompactEncoder::Way {
  Prediction prediction = Prediction::intra;
  ReferenceList references = {};
};

// Where the motion is not smooth, fewer references or none may do better.
CompactEncoder::Way CompactEncoder::smallest(const QuantisedFrame& frame,
                                             const ReferenceList& planned, const Decoded& decoded) {
  Way best;
  const ReferenceList all = first_of(planned, usable(frames_of(planned, decoded)).size());
  if (frame.plain || all.size() == 0) return best;
  std::size_t fewest_bytes = encode(frame, best, decoded, Fit::quick).geometry.size();
  for (const Way& way : {Way{Prediction::b, all}, Way{Prediction::b, first_of(all, 2)},
                         Way{Prediction::p, first_of(all, 3)}}) {
    const std::size_t bytes = encode(frame, way, decoded, Fit::quick).geometry.size() +
                              sizeof(std::uint32_t) * way.references.size();
    if (bytes >= fewest_bytes) continue;
    fewest_bytes = bytes;
    best = way;
  }
  return best;
}

EncodedFrame CompactEncoder::encode(const QuantisedFrame& frame, const Way& way,
                                    const Decoded& decoded, Fit fit) {
  return encoder_.encode_rounded(frame, frames_of(way.references, decoded), way.prediction, fit);
}

CompactedFrame CompactEncoder::encode(const QuantisedFrame& frame, const ReferenceList& planned,
                                      const Decoded& decoded) {
  const Way way = smallest(frame, planned, decoded);
  return {encode(frame, way, decoded, Fit::thorough), way.references};
}

}  // namespace ribbon
