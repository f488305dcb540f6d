#include "recorder/start.h"

#include <utility>

#include "curve/space_curve.h"
#include "obstacle/obstacle.h"
#include "recorder/tying.h"

namespace ribbon {

namespace {

// The gate can grow a ribbon into less room than it needs at its crossings.
Result<SpaceCurve> centre_line(const Scene& scene) {
  return generate_space_curve(
      scene.curve, scene.ribbon.width_m, scene.ribbon.along,
      scene.contact == ContactMethod::gate ? TightPassage::squeeze : TightPassage::refuse);
}

// A start without room is told with the tightest passage of the drawing, if that was squeezed.
Error with_tight_passage(const Scene& scene, Error error) {
  const auto roomy = generate_space_curve(scene.curve, scene.ribbon.width_m, scene.ribbon.along);
  if (!roomy) error.problem += " (" + roomy.error().place + ": " + roomy.error().problem + ")";
  return error;
}

// Growth keeps the knot; the recovery schemes know nothing of it.
Result<void> start_is_tied_as_drawn(const Scene& scene, const RibbonMesh& ribbon,
                                    const std::optional<TriangleMesh>& obstacle,
                                    const FasteningProcessor& fastening) {
  if (scene.contact != ContactMethod::gate || fastening.start().kind != StartKind::recovered)
    return {};
  auto tied = check_tying(ribbon.grid, object_axis(centre_axis(scene), obstacle), ribbon.positions,
                          fastening.positions());
  if (!tied) tied.error().place = scene.name;
  return tied;
}

}  // namespace

Result<std::optional<TriangleMesh>> read_obstacle_of(const Scene& scene) {
  if (!scene.obstacle) return std::nullopt;
  return read_obstacle(*scene.obstacle).map([](TriangleMesh mesh) {
    return std::optional(std::move(mesh));
  });
}

Result<Start> find_start(const Scene& scene, const std::optional<TriangleMesh>& obstacle,
                         const StartObserver& observer) {
  const auto curve = centre_line(scene);
  if (!curve) return tl::unexpected(curve.error());
  RibbonMesh ribbon = generate_ribbon_mesh(*curve, scene.ribbon, scene.curve.axis);
  auto fastening = FasteningProcessor::create(scene, ribbon, obstacle, observer);
  if (!fastening) return tl::unexpected(with_tight_passage(scene, fastening.error()));
  if (auto tied = start_is_tied_as_drawn(scene, ribbon, obstacle, *fastening); !tied)
    return tl::unexpected(tied.error());
  return Start{std::move(ribbon), *std::move(fastening)};
}

std::optional<CentreAxis> centre_axis(const Scene& scene) {
  if (!scene.fastening) return std::nullopt;
  return CentreAxis{scene.fastening->axis_point_m, scene.fastening->axis_direction};
}

}  // namespace ribbon
