#include "ribbon_mesh/ribbon_mesh.h"

#include <cassert>
#include <cmath>

#include "ribbon_mesh/width_vectors.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// Narrower, and the tip's edges would set every gap; steeper, and quads are no rectangles any more.
constexpr double least_across = 1.0 / 8;  // of the way from row to row
constexpr double steepest = 1;            // change of width per length

Result<void> is_wide_enough(const RibbonScene& ribbon, const RestSize& size) {
  const double narrowest_m = size.narrowest_m();
  const double across_m = size.narrowest_across_m();
  const double least_m = least_across * size.along_m();
  if (across_m >= least_m) return {};
  const int fewer = 1 + static_cast<int>(narrowest_m / least_m);
  return failure(
      ribbon.profile->place,
      filled_in("where the ribbon is {} wide its particles are {} apart, less than an "
                "eighth of the {} from row to row, and would set every gap",
                metres(narrowest_m), metres(across_m), metres(size.along_m())),
      (fewer >= 2 ? filled_in("set ribbon.across to {} or less, or ", fewer) : "") +
          filled_in("make it no narrower than {}", metres(1.01 * least_m * (ribbon.across - 1))));
}

Result<void> is_gentle(const RibbonScene& ribbon, const RestSize& size) {
  for (int row = 0; row + 1 < ribbon.along; ++row) {
    const double change_m = std::abs(size.row_width_m(row + 1) - size.row_width_m(row));
    if (change_m <= steepest * size.along_m()) continue;
    return failure(ribbon.profile->place,
                   filled_in("at {} of its length the ribbon becomes wider or narrower by {} from "
                             "one row to the next, which is {} away",
                             short_number((row + 0.5) / (ribbon.along - 1), 3), metres(change_m),
                             metres(size.along_m())),
                   "let its width change over a longer part of it, by at most as much as the "
                   "part is long");
  }
  return {};
}

Result<void> mesh_holds_profile(const RibbonScene& ribbon, const RestSize& size) {
  if (!ribbon.profile) return {};
  return is_wide_enough(ribbon, size).and_then([&] { return is_gentle(ribbon, size); });
}

}  // namespace

Result<RibbonMesh> draw_ribbon(const Scene& scene, const std::optional<TriangleMesh>& obstacle) {
  const auto curve = generate_space_curve(
      scene.curve, scene.ribbon,
      scene.contact == ContactMethod::gate ? TightPassage::squeeze : TightPassage::refuse,
      heights_of(obstacle, scene.curve));
  if (!curve) return tl::unexpected(curve.error());
  RibbonMesh mesh = generate_ribbon_mesh(*curve, scene.ribbon, scene.curve.axis);
  if (auto held = mesh_holds_profile(scene.ribbon, mesh.size()); !held)
    return tl::unexpected(held.error());
  return mesh;
}

RibbonMesh generate_ribbon_mesh(const SpaceCurve& curve, const RibbonScene& ribbon, Axis axis) {
  assert(curve.points.cols() == ribbon.along && ribbon.across >= 2);
  RibbonMesh mesh;
  mesh.grid = {ribbon.along, ribbon.across};
  mesh.curve = curve.points;
  mesh.length_m = curve.length_m;
  mesh.width_m = ribbon.width_m;
  mesh.row_widths_m = row_widths_m(ribbon);
  mesh.crossings = curve.crossings;
  mesh.objects = curve.objects;
  mesh.passage_shares = curve.passage_shares;
  mesh.squeezed = curve.squeezed;
  mesh.positions.resize(3, mesh.grid.particle_count());
  mesh.uv.resize(2, mesh.grid.particle_count());

  const Eigen::Matrix3Xd widths =
      width_vectors(curve.points, Eigen::Vector3d::Unit(static_cast<int>(axis)), ribbon.width_m);
  const RestSize size = mesh.size();
  for (int i = 0; i < ribbon.along; ++i) {
    for (int j = 0; j < ribbon.across; ++j) {
      const int particle = mesh.grid.particle(i, j);
      const double u = static_cast<double>(i) / (ribbon.along - 1);
      const double v = static_cast<double>(j) / (ribbon.across - 1);
      mesh.positions.col(particle) =
          curve.points.col(i) + (v - 0.5) * size.row_width_m(i) * widths.col(i);
      mesh.uv.col(particle) << static_cast<float>(u), static_cast<float>(v);
    }
  }
  return mesh;
}

}  // namespace ribbon
