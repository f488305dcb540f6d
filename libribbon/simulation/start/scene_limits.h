// What numbers can hold: scenes whose own numbers would break a promise are refused.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/rest_size.h"
#include "geometry/ribbon_grid.h"
#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "scene/scene.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/integration/integrator.h"

namespace ribbon {

// How far from 0 recorded coordinates may come without breaking what is promised: where the scene
// wants positions recorded without loss a power of two, at least twice what the ribbon reaches at
// its start (3 x particles) and could reach by its length; the largest number otherwise.
double recorded_reach_m(const Scene& scene, const RestSize& size,
                        const Eigen::Matrix3Xd& positions);

// With a max_position_error above 0. A scene that wants no loss has the rounding to single
// precision within its reach. One that names none has 1e-5, or less where strain correction would
// otherwise aim at less than 5 % for an edge, or 7 % for one along the ribbon (with contact =
// "paper" never less), but at least least_position_error.
Scene with_rounding(Scene scene, const RestSize& size, double reach_m);

// positions: 3 x particles, the ribbon of `size`; lengths: of it, with rounding. Fails,
// naming the setting and its limit, where
// - a position is not finite or so far from the origin that arithmetic would blur the gap that the
//   gate keeps (a thousandth of it),
// - recorded coordinates, in single precision, cannot hold recording.max_position_error,
// - what recording may move a coordinate by uses up that gap (a scene that wants no loss) or leaves
//   strain correction too little to aim at (any other); not with contact = "paper".
// Of a ribbon with a width and a length that were hardly meant, it names these instead. An error
// that is proposed passes all of it.
Result<void> check_precision(const Scene& as_read, const RestSize& size,
                             const ContactLengths& lengths, const Eigen::Matrix3Xd& positions,
                             const std::optional<TriangleMesh>& obstacle);

// Fails, with the scene's place of it, where the fabric is too thick for the particles: layers
// would rest on far more of each other than they touch.
Result<void> check_fabric(const Scene& scene, const RestSize& size);

// Fails where the ribbon is too wide for the integrator that the scene names.
Result<void> check_width(const Scene& scene, const RibbonGrid& grid);

// Fails where springs and air divide a step into more parts than an explicit scheme may: the one
// that the scene names or, for a ribbon too wide for the implicit one, the usual one.
Result<void> check_substeps(const Scene& scene, const SpringNetwork& springs,
                            const Integrator& integrator);

}  // namespace ribbon
