// A step that knows of no contact: nothing is kept apart, and the gate lets everything pass. Linked
// into a program this takes the place of the product's sources of the same names
// (libribbon/simulation/truncation), which a static library only provides where nothing else does.
#include "simulation/truncation/contact_constraints.h"
#include "simulation/truncation/displacement_truncation.h"

namespace ribbon {

void ContactConstraints::find(const ContactCandidates& /*candidates*/, const Bodies& /*bodies*/,
                              const PairDistances& /*distances*/, double /*beyond_m*/,
                              const Eigen::Matrix3Xd& /*free_positions*/,
                              const Eigen::Matrix3Xd& /*target*/,
                              const Eigen::Vector3d& /*fall_m*/) {}

void ContactConstraints::begin_sweeps() {}

bool ContactConstraints::keep_apart(double /*friction*/, const Eigen::Matrix3Xd& /*before*/,
                                    const Bodies& /*bodies*/, SweepActivity& /*activity*/,
                                    Cloth& /*cloth*/) {
  return false;
}

}  // namespace ribbon
