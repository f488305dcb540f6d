// The knot of a ribbon, or of a part of it, certified frame after frame.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "geometry/object_axis.h"
#include "knot/knot_witness.h"
#include "knot/ribbon_part.h"

namespace ribbon {

// The certificates of the two frames, both known or carried on, differ, as texts say. What lies
// between them is not known. Frames are numbered from 1.
struct CertificateChange {
  int frame_before = 0;
  int frame_after = 0;
  std::string before;
  std::string after;
  double moved_m = 0;  // the farthest that a particle went from one frame to the next meanwhile
};

// Straight ways from one frame to the next do not show that the centre line did not pass through
// itself.
struct FarMove {
  int frame_before = 0;
  int frame_after = 0;
  double moved_m = 0;  // the farthest that a particle went
};

// The knot of the last frame by itself, closed where that is clearest.
struct ClosedAnew {
  std::string knot;
  bool is_the_same = false;  // as when an end got buried
};

struct CertifiedKnot {
  std::string certificate;  // of the first frame that could be read; empty: none could
  int certified_frames = 0;
  // Of these, where no closure tells knot and twist, for an end is buried, but where they are what
  // they were before. Where a knot is expected there are none: then such frames are uncertain.
  int buried_frames = 0;
  int uncertain_frames = 0;   // of these, where knot or twist could not be known
  int unexpected_frames = 0;  // of these, where it was another than the one expected
  std::vector<CertificateChange> changes;
  // Where first an end may have turned the longer way between frames, or gone so far that it may
  // have turned any way, so that the twist is not known.
  std::optional<CertificateChange> turned_too_far;
  std::optional<int> buried_since;         // the frame in which first an end is buried
  std::optional<FarMove> may_have_passed;  // the first since then
  // Nothing where no end got buried, where the knot was not known before, or is not known at last.
  std::optional<ClosedAnew> closed_anew;
};

class KnotCertifier {
 public:
  // Of all rows of the grid, or of a part of them. Without `axis`, turns are not counted.
  // `expected`: the name of a closed type; empty: any.
  KnotCertifier(const RibbonGrid& grid, std::optional<RibbonPart> part,
                const std::optional<ObjectAxis>& axis, std::string expected);

  // The next frame, index from 0: 3 x the particles of the whole grid. All frames in order, as
  // KnotWitness wants them; `certify` those whose certificate is wanted. The first always gets one.
  void follow(int index, const Eigen::Matrix3Xf& positions, bool certify);

  [[nodiscard]] const KnotWitness& witness() const { return witness_; }

  // With the certificate of the frame followed last.
  CertifiedKnot finish();

 private:
  struct Known {
    int index;
    KnotCertificate certificate;
    int wide_turns;      // until then
    double moved_m = 0;  // since then, as CertificateChange has it
  };

  void watch(int index, Eigen::Matrix3Xf positions);
  void certify(int index, KnotCertificate certificate);
  [[nodiscard]] bool tells_the_knot(const KnotCertificate& certificate) const;
  [[nodiscard]] bool turned_ends_explain(const KnotCertificate& certificate) const;
  [[nodiscard]] std::optional<ClosedAnew> closed_anew() const;

  RibbonGrid grid_;
  std::optional<RibbonPart> part_;
  KnotWitness witness_;
  Eigen::Matrix3Xf positions_;  // of the frame followed last
  std::string expected_;
  int followed_ = -1;           // index of the frame followed last
  int certified_ = -1;          // and of the one certified last
  std::optional<Known> known_;  // the last that tells the knot
  // index of the frame before the one in which first an end is buried; none: there is none
  std::optional<int> last_closed_;
  CertifiedKnot result_;
};

}  // namespace ribbon
