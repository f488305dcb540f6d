// Verifies a recording frame by frame: that nothing intersects, that the stated gap and the limit
// of strain are kept, that the knot stays the knot. docs/verification.md says what is proved and
// how.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "inspection/certified_knot.h"
#include "inspection/outcome.h"
#include "knot/ribbon_part.h"
#include "playback/recording_reader.h"
#include "recording/records/recording.h"
#include "result/result.h"
#include "verification/frame_verifier.h"

namespace ribbon {

// Frames are numbered from 1 in all of these.

struct Intersection {
  int frame = 0;
  std::optional<double> time_s;  // nothing where the frame's numbers are lost
  TrianglePair pair;             // as in FrameVerdict
};

struct MostIntersections {
  std::size_t pairs = 0;
  int frame = 0;
};

struct SmallestGapFrame {
  SmallestGap gap;
  int frame = 0;
};

struct LargestStrainFrame {
  LargestStrain strain;
  int frame = 0;
};

// A strand has passed over an end of the object since the frame before, or came back: how often the
// ribbon goes round the object has changed. That is no fault.
struct PassageOverEnd {
  int frame = 0;
  std::optional<double> time_s;  // nothing where the frame's numbers are lost
  int turns_before = 0;
  int turns_after = 0;
};

// A part of the ribbon, for itself.
struct PartVerification {
  RibbonPart rows;
  std::string expected;  // the name of a knot; empty: any
  CertifiedKnot knot;
};

struct Verification {
  RecordingHeader header;
  int frames_asked = 0;
  int frames_checked = 0;
  std::vector<int> lost;        // frames asked for that cannot be decoded
  std::vector<int> not_finite;  // frames with a coordinate that is no number: nothing else is known
  bool damaged = false;         // something in the file is, perhaps outside of these frames

  std::size_t intersecting_pairs = 0;
  bool all_pairs_counted = true;  // false: there may be more in frames that are full of them
  int intersecting_frames = 0;
  std::optional<MostIntersections> most_intersections;
  std::vector<Intersection> first_intersections;  // one of each of the first frames that have any

  std::optional<SmallestGapFrame> smallest_gap;
  std::optional<LargestStrainFrame> largest_strain;  // of the limited edges, if any is

  CertifiedKnot knot;
  std::vector<PassageOverEnd> passages_over_ends;
  std::vector<PartVerification> parts;  // first the one that the recording asks for itself

  std::optional<Outcome> outcome;  // of the recording, whatever frames were asked for

  // Is no gap smaller than the stated one? True where none is stated.
  [[nodiscard]] bool keeps_stated_gap() const;
  // Is no limited edge strained further than the recording states? True where it states no limit.
  [[nodiscard]] bool keeps_strain_limit() const;
  // What is wrong, as parts of a sentence; empty: nothing.
  [[nodiscard]] std::vector<std::string> complaints() const;
};

// What is to be verified.
struct VerificationOrder {
  std::vector<int> frames;  // indices from 0, ascending, at least one
  int certify_every = 10;   // frames from one certificate of the knot to the next
  // Shares of the ribbon's length between which its knot is certified by itself, beside those that
  // the recording asks for.
  std::optional<std::array<double, 2>> between = std::nullopt;
};

// Called with the number of frames that are done; false stops.
using VerificationObserver = std::function<bool(int)>;

// Certificates are computed for the first and the last frame, too; to follow the ribbon's ends, the
// frames in between are decoded as well. Fails when the observer stops it, and where no two rows
// lie between the places that are asked for. The answer does not depend on the number of threads.
Result<Verification> verify_recording(RecordingReader& reader, const VerificationOrder& order,
                                      const VerificationObserver& observer);

}  // namespace ribbon
