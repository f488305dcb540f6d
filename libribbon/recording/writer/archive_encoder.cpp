#include "recording/writer/archive_encoder.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace ribbon {

namespace {

ReferenceList first_of(const ReferenceList& references, std::size_t count) {
  ReferenceList first;
  for (std::size_t k = 0; k < std::min(count, references.size()); ++k)
    first.push_back(references[k]);
  return first;
}

std::vector<const LatticeFrame*> lattices_of(const ReferenceList& references,
                                             const ArchiveEncoder::Decoded& decoded) {
  std::vector<const LatticeFrame*> lattices;
  for (const std::uint32_t reference : references) lattices.push_back(&decoded(reference));
  return lattices;
}

}  // namespace

// What a frame may be predicted from, and how.
struct ArchiveEncoder::Way {
  Prediction prediction = Prediction::within;
  ReferenceList references = {};
};

// Where the motion is not smooth, fewer references or none may do better.
ArchiveEncoder::Way ArchiveEncoder::smallest(const LatticeFrame& frame,
                                             const ReferenceList& planned, const Decoded& decoded) {
  Way best;
  const ReferenceList all = first_of(planned, usable(lattices_of(planned, decoded)).size());
  if (frame.plain || all.size() == 0) return best;
  std::size_t fewest_bytes = encode(frame, best, decoded, Fit::quick).geometry.size();
  for (const Way& way : {Way{Prediction::between, all}, Way{Prediction::between, first_of(all, 2)},
                         Way{Prediction::forward, first_of(all, 3)}}) {
    const std::size_t bytes = encode(frame, way, decoded, Fit::quick).geometry.size() +
                              sizeof(std::uint32_t) * way.references.size();
    if (bytes >= fewest_bytes) continue;
    fewest_bytes = bytes;
    best = way;
  }
  return best;
}

EncodedFrame ArchiveEncoder::encode(const LatticeFrame& frame, const Way& way,
                                    const Decoded& decoded, Fit fit) {
  return encoder_.encode_rounded(frame, lattices_of(way.references, decoded), way.prediction, fit);
}

ArchivedFrame ArchiveEncoder::encode(const LatticeFrame& frame, const ReferenceList& planned,
                                     const Decoded& decoded) {
  const Way way = smallest(frame, planned, decoded);
  return {encode(frame, way, decoded, Fit::thorough), way.references};
}

}  // namespace ribbon
