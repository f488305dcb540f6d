// A gate that lets everything pass. Linked into a program this takes the place of the product's
// source of the same name (libribbon/simulation/truncation).
#include "simulation/truncation/displacement_truncation.h"

namespace ribbon {

const TruncationReport& DisplacementTruncation::truncate(const ContactCandidates& /*candidates*/,
                                                         const Bodies& /*bodies*/,
                                                         const PairDistances& /*distances*/,
                                                         const Eigen::Matrix3Xd& target,
                                                         Eigen::Matrix3Xd& positions) {
  positions = target;
  return report_;
}

}  // namespace ribbon
