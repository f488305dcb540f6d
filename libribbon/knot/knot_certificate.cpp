#include "knot/knot_certificate.h"

#include <cstdlib>

#include "knot/type/knot_names.h"

namespace ribbon {
namespace {

std::string counted(int count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (std::abs(count) == 1 ? "" : "s");
}

std::string knot_state(const KnotCertificate& certificate) {
  if (certificate.broken_positions) return "broken positions";
  if (certificate.first_end_buried) return "first end buried, knot unknown";
  if (certificate.last_end_buried) return "last end buried, knot unknown";
  if (!certificate.jones) return "knot too tangled to be known";
  return knot_text(*certificate.jones);
}

}  // namespace

std::string KnotCertificate::text() const {
  std::string result = knot_state(*this);
  if (turns_round_object)
    result += "; " + counted(*turns_round_object, "turn") + " round the object";
  if (object_met) result += ", which was met";
  if (selvage_linking) result += "; selvages linked " + counted(*selvage_linking, "time");
  return result;
}

}  // namespace ribbon
