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

namespace ribbon {

// How far from 0 recorded coordinates may come without breaking what is promised: where the scene
// wants positions recorded without loss a power of two, at least twice what the ribbon reaches at
// its start (3 x particles) and could reach by its length; the largest number otherwise.
double recorded_reach_m(const Scene& scene, const RestSize& size,
                        const Eigen::Matrix3Xd& positions);

// With a max_position_error above 0. A scene that wants no loss has the rounding to single
// precision within its reach. One that names none has 1e-5, or less where edges would otherwise be
// held to less than half of the paper's limit of strain, but at least least_position_error.
Scene with_rounding(Scene scene, const RestSize& size, double reach_m);

// positions: 3 x particles, the ribbon of `size`; lengths: of it, with single rounding. Fails,
// naming the setting and its limit, where
// - a position is not finite or so far from the origin that arithmetic would blur the gap that the
//   gate keeps (a thousandth of it),
// - recorded coordinates, in single precision, cannot hold recording.max_position_error,
// - what recording may move a coordinate by uses up that gap (not with contact = "paper", which
//   keeps none).
Result<void> check_precision(const Scene& as_read, const RestSize& size,
                             const ContactLengths& lengths, const Eigen::Matrix3Xd& positions,
                             const std::optional<TriangleMesh>& obstacle);

// Fails, with the scene's place of it, where the fabric is too thick for the particles: layers
// would rest on far more of each other than they touch.
Result<void> check_fabric(const Scene& scene, const RestSize& size);

// Fails where the ribbon is too wide, in particles, for its integrator: `implicit` solves in as
// many modes across the ribbon, each over all of its width. Within the limit no cache size of a
// machine changes the order of its sums.
Result<void> check_width(const Scene& scene, const RibbonGrid& grid);

// Into how many parts springs and air may divide a step of the scene; any number where its
// integrator makes only one. Contact acts once a step, the springs in each part: springs that swing
// many times between two contacts turn what contact strains into motion, without a bound.
int most_substeps(const Scene& scene);

// Fails where springs and air divide a step into more than most_substeps parts.
Result<void> check_substeps(const Scene& scene, int substeps);

}  // namespace ribbon
