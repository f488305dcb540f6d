// How a step deals with contact.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "simulation/bodies.h"
#include "simulation/cloth.h"
#include "simulation/natural_size.h"

namespace ribbon {

// What contact needs to know of a ribbon and its recording.
struct ContactProperties {
  NaturalSize size;
  double rounding_m = 0;   // how far recording may move a coordinate
  double thickness_m = 0;  // of the cloth
  double friction = 0;     // Coulomb's coefficient
};

// The two moments of a step at which contact decides on what cloth.positions wish so far.
class Contact {
 public:
  virtual ~Contact() = default;

  // After the displacement from `before`: detecting collisions and adding repulsions (section 5.4).
  virtual void after_displacement(const Eigen::Matrix3Xd& before, Cloth& cloth) = 0;

  // After the smoothing: recovering from errors (section 5.6), or not letting them happen. Returns
  // how often a recovery scheme was applied. Called any number of times after after_displacement.
  virtual int after_smoothing(Cloth& cloth) = 0;
};

// As published: collisions are repelled as far as they are found, smoothing may push the ribbon
// through itself, and schemes A, B and C bring it back as well as they can.
std::unique_ptr<Contact> paper_contact(Bodies& bodies, const ContactProperties& properties);

// Collisions are repelled likewise, but positions reach the cloth only through the gate, so that
// what did not intersect at the start never does. `step_s` turns what the gate holds back into
// velocity.
std::unique_ptr<Contact> gated_contact(Bodies& bodies, const ContactProperties& properties,
                                       double step_s);

}  // namespace ribbon
