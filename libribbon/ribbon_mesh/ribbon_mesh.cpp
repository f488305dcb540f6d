#include "ribbon_mesh/ribbon_mesh.h"

#include <cassert>

#include "ribbon_mesh/width_vectors.h"

namespace ribbon {

Result<RibbonMesh> draw_ribbon(const Scene& scene, const std::optional<TriangleMesh>& obstacle) {
  const auto curve = generate_space_curve(
      scene.curve, scene.ribbon.width_m, scene.ribbon.along,
      scene.contact == ContactMethod::gate ? TightPassage::squeeze : TightPassage::refuse,
      heights_of(obstacle, scene.curve));
  if (!curve) return tl::unexpected(curve.error());
  return generate_ribbon_mesh(*curve, scene.ribbon, scene.curve.axis);
}

RibbonMesh generate_ribbon_mesh(const SpaceCurve& curve, const RibbonScene& ribbon, Axis axis) {
  assert(curve.points.cols() == ribbon.along && ribbon.across >= 2);
  RibbonMesh mesh;
  mesh.grid = {ribbon.along, ribbon.across};
  mesh.curve = curve.points;
  mesh.length_m = curve.length_m;
  mesh.width_m = ribbon.width_m;
  mesh.crossings = curve.crossings;
  mesh.objects = curve.objects;
  mesh.passage_shares = curve.passage_shares;
  mesh.squeezed = curve.squeezed;
  mesh.positions.resize(3, mesh.grid.particle_count());
  mesh.uv.resize(2, mesh.grid.particle_count());

  const Eigen::Matrix3Xd widths =
      width_vectors(curve.points, Eigen::Vector3d::Unit(static_cast<int>(axis)), ribbon.width_m);
  for (int i = 0; i < ribbon.along; ++i) {
    for (int j = 0; j < ribbon.across; ++j) {
      const int particle = mesh.grid.particle(i, j);
      const double u = static_cast<double>(i) / (ribbon.along - 1);
      const double v = static_cast<double>(j) / (ribbon.across - 1);
      mesh.positions.col(particle) =
          curve.points.col(i) + (v - 0.5) * ribbon.width_m * widths.col(i);
      mesh.uv.col(particle) << static_cast<float>(u), static_cast<float>(v);
    }
  }
  return mesh;
}

}  // namespace ribbon
