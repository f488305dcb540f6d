// How a band lets go of what bending it into its drawn curve has strained.
#pragma once

#include "geometry/rest_size.h"
#include "scene/scene.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/detection/bodies.h"
#include "simulation/state/cloth.h"

namespace ribbon {

// Dynamic relaxation with kinetic damping (Barnes, Form Finding and Analysis of Tension Structures
// by Dynamic Relaxation, 1999): moved by its springs alone, without weight, air, friction and
// hands, the band is stopped whenever its kinetic energy falls. It is done when that has come down
// to a hundredth of the most that it has been; when a particle has gone half of a width, since it
// is to begin where it was drawn; or after 60 steps. All motion passes the gate. Leaves the cloth
// at rest, and as it is where no spring but those of bending is strained by more than 1 %. Its
// steps are its own, so that a ribbon with room begins alike at all accuracies. Returns how many
// steps it took.
//
// scene.contact must be the gate, and the cloth free and within the limit of strain; `lengths` are
// of a band of that size.
int relax(const Scene& scene, const RestSize& size, const ContactLengths& lengths, Bodies& bodies,
          Cloth& cloth);

}  // namespace ribbon
