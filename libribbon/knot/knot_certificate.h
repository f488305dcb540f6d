// What no motion without passing through itself can change about a ribbon tied round an object.
#pragma once

#include <optional>
#include <string>
#include <tuple>

#include "knot/type/laurent_polynomial.h"

namespace ribbon {

// Known certificates of two frames differ only if something passed through something. (That all
// that passes is seen they cannot promise: docs/knot-certificate.md, its limits.)
struct KnotCertificate {
  // An end is buried when no straight ray leads from it to the far without meeting the ribbon, or
  // none that continues the closure of the frames before. It stays so: what the ribbon was closed
  // to before cannot be known again.
  bool first_end_buried = false;
  bool last_end_buried = false;
  // Since then it is not proved of all steps from frame to frame that the centre line, all points
  // going straight, did not pass through itself or through a line close beside it. Where it is,
  // knot and twist are what they were, as far as the frames do not intersect.
  bool may_have_passed = false;
  // Some coordinate of a frame was infinite or not a number.
  bool broken_positions = false;

  // Jones polynomial of the centre line: the type of the knot, mirror images apart. Empty when an
  // end is buried or the diagram is too tangled to be computed.
  std::optional<LaurentPolynomial> jones;
  // Linking number of the two selvages. Empty when an end is buried.
  std::optional<int> selvage_linking;
  // How often the centre line goes round the object, counter-clockwise looking against the
  // direction of its axis, but for turns that have come or gone over the ends of the object. Empty
  // without an object.
  std::optional<int> turns_round_object;
  // The centre line, or the trail of one of its ends, has met the axis within the object exactly.
  bool object_met = false;

  // Are knot and twist known?
  [[nodiscard]] bool is_known() const { return jones && selvage_linking; }
  // Though no closure tells them, are they what they were when the end got buried?
  [[nodiscard]] bool is_carried_on() const {
    return (first_end_buried || last_end_buried) && !may_have_passed && !broken_positions;
  }
  // Does it prove that something has passed through something since the earlier frame? Certificates
  // that are neither known nor carried on prove nothing.
  [[nodiscard]] bool contradicts(const KnotCertificate& earlier) const {
    if (is_known() && earlier.is_known()) return *this != earlier;
    return std::tie(turns_round_object, object_met) !=
           std::tie(earlier.turns_round_object, earlier.object_met);
  }

  // For people, on one line, such as "trefoil, right-handed (3 crossings); 1 turn round the object;
  // selvages linked 2 times".
  [[nodiscard]] std::string text() const;

  bool operator==(const KnotCertificate&) const = default;
  // But for how often the selvages are linked.
  [[nodiscard]] bool equals_but_for_twist(const KnotCertificate& other) const {
    KnotCertificate twisted_as_other = *this;
    twisted_as_other.selvage_linking = other.selvage_linking;
    return twisted_as_other == other;
  }
};

}  // namespace ribbon
