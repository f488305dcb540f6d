// A gate that lets everything pass. Linked into a program it takes the place of the product's
// (libribbon/simulation/truncation/displacement_truncation.cpp), which a static library only
// provides where nothing else does.
#include "simulation/truncation/displacement_truncation.h"

namespace ribbon {

TruncationReport truncate_displacements(const ContactCandidates& /*candidates*/,
                                        const Bodies& /*bodies*/,
                                        const PairDistances& /*distances*/,
                                        const Eigen::Matrix3Xd& target,
                                        Eigen::Matrix3Xd& positions) {
  positions = target;
  return {};
}

}  // namespace ribbon
