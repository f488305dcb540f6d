#include "ribbon_mesh/fabric_springs.h"

#include <algorithm>

#include "scene/setting.h"

namespace ribbon {

namespace {

constexpr double most_bend_of_stretch = 1.0 / 14;

double stretch_n_m(const Fabric& fabric) {
  return std::min(fabric.stretch_n_m, most_stretch_of_mass_m2_s2 * fabric.mass_kg_m2);
}

double shear_stiffness(const Fabric& fabric, const RestSize& size) {
  const double a = size.along_m();
  const double b = size.across_m();
  return fabric.shear_n_m * (a * a + b * b) / (2 * a * b);
}

double bend_stiffness(const Fabric& fabric, double line_m, double a) {
  const double turn = a * bending_matched_per_m;
  return 16 * fabric.bending_nm * line_m / (a * a * a * turn * turn);
}

}  // namespace

SpringScene springs_of(const Fabric& fabric, const RestSize& size) {
  const double a = size.along_m();
  const double line_m = size.width_m / size.grid.across;
  const double together = stretch_n_m(fabric) * line_m / a;
  const double bend = std::min(bend_stiffness(fabric, line_m, a), most_bend_of_stretch * together);
  return {.stretch = together - 4 * bend,
          .shear = shear_stiffness(fabric, size),
          .bend = bend,
          .damping = fabric.damping};
}

Scene with_fabric(Scene scene, const RestSize& size) {
  if (!scene.cloth) return scene;
  const ClothScene& cloth = *scene.cloth;
  const SpringScene springs = springs_of(cloth.fabric, size);
  if (cloth.tells_mass)
    scene.ribbon.mass_kg = cloth.fabric.mass_kg_m2 * size.length_m * size.width_m;
  if (cloth.tells_stretch) scene.springs.stretch = springs.stretch;
  if (cloth.tells_shear) scene.springs.shear = springs.shear;
  if (cloth.tells_bend) scene.springs.bend = springs.bend;
  return scene;
}

std::string fabric_settings(const Scene& scene, const RestSize& size) {
  if (!scene.cloth) return "";
  const Scene told = with_fabric(scene, size);
  return setting_of("ribbon.mass", told.ribbon.mass_kg) + "\n" +
         setting_of("ribbon.thickness", told.ribbon.thickness_m) + "\n" +
         setting_of("springs.stretch", told.springs.stretch) + "\n" +
         setting_of("springs.shear", told.springs.shear) + "\n" +
         setting_of("springs.bend", told.springs.bend) + "\n" +
         setting_of("springs.damping", told.springs.damping) + "\n" +
         setting_of("friction.coefficient", told.friction) + "\n";
}

}  // namespace ribbon
