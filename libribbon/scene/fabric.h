// Cloth by name. docs/fabrics.md tells where each number comes from.
#pragma once

#include <array>
#include <string_view>

namespace ribbon {

// What is measured of a fabric, whatever the size of the piece.
struct Fabric {
  std::string_view name;   // in scene files
  double mass_kg_m2 = 0;   // per area
  double thickness_m = 0;  // at which layers rest on each other
  double stretch_n_m = 0;  // force per width, over strain
  double shear_n_m = 0;    // force per length, over the angle of shear in radians
  double bending_nm = 0;   // moment per width, over curvature: newton metres
  double damping = 0;      // SpringScene::damping
  double friction = 0;     // Coulomb's coefficient

  bool operator==(const Fabric&) const = default;
};

// Recordings keep the name alone, so a fabric that has been released keeps its numbers.
extern const std::array<Fabric, 7> fabrics;

}  // namespace ribbon
