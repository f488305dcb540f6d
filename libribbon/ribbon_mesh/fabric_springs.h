// A fabric that was measured as masses and springs.
#pragma once

#include <string>

#include "geometry/rest_size.h"
#include "scene/fabric.h"
#include "scene/scene.h"

namespace ribbon {

// Where measured bending and that of the springs are the same: 1 / cm, in the middle of the range
// over which the KES-FB2 tester takes the slope (0.5 to 1.5 / cm).
inline constexpr double bending_matched_per_m = 100;

// Stretch per mass per area that springs get at most, the square of the speed at which a pull runs
// along the band. Drawn bands begin strained by up to 8 %, and what that stores throws them about:
// measured on silk round an hourglass, 50 times as much ends in a tangle, 5 times as much makes
// ends whirl. With this the hands strain the band by 1 %; edges are kept within 10 % anyhow.
inline constexpr double most_stretch_of_mass_m2_s2 = 500;

// The springs that make a band of that size resist as the fabric, however many particles it has.
//
// a, b: from row to row, and from particle to particle in a row; w: the width over the number of
// columns, the share of it that each line of springs along stands for.
//
// - Shear by an angle changes both diagonals of a quad by angle x ab / d, d² = a² + b². Their
//   energy is that of the area ab of the fabric, ½ G ab angle², where
//   shear = G (a² + b²) / 2ab.
// - Bending: a line that is bent by a curvature c into edges of length a turns by ac at each
//   particle, and the spring over two edges shortens by a³c² / 4. The moment of such springs grows
//   with c³, the fabric's with c. Both have the same energy, ½ B w a c², at c = 1 / cm where
//   bend = 16 B w / (a⁵ c²). In a mesh so fine that this is more than a fourteenth of what a line
//   resists stretch, edges would give way instead; bend stays at that, and cloth folds more easily.
// - Stretch: a line must bear E w x strain, E the fabric's or the most of above. Springs over two
//   edges bear as much as four times the same stiffness between neighbours, so
//   stretch = E w / a - 4 bend. (What the diagonals bear, G a² / b² of E, is left out.)
//
// Exact along the band. Across it the same numbers hold as far as a is b.
SpringScene springs_of(const Fabric& fabric, const RestSize& size);

// A scene that says what its fabric tells: mass and resistances of a mesh of that size. Others, and
// what the scene says itself, stay as they are.
Scene with_fabric(Scene scene, const RestSize& size);

// What counts in a scene with a fabric, as settings that say so, one a line; empty without one.
std::string fabric_settings(const Scene& scene, const RestSize& size);

}  // namespace ribbon
