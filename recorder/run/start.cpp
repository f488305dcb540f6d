#include "recorder/run/start.h"

#include <utility>

#include "recorder/run/drawn_knot.h"
#include "recorder/run/tied_as_drawn.h"

namespace ribbon {

namespace {

// Growth keeps how the ribbon is tied; the recovery schemes know nothing of it.
Result<void> start_is_tied_as_drawn(const Scene& scene, const RibbonMesh& ribbon,
                                    const std::optional<TriangleMesh>& obstacle,
                                    const FasteningProcessor& fastening) {
  if (scene.contact != ContactMethod::gate) return {};
  auto tied = fastening.start().kind == StartKind::recovered
                  ? check_tied_as_drawn(ribbon.grid, object_axis(centre_axis(scene), obstacle),
                                        ribbon.positions, fastening.positions())
                  : Result<void>();
  if (tied) tied = check_first_frame(scene, ribbon, fastening.positions());
  if (!tied) tied.error().place = scene.name;
  return tied;
}

}  // namespace

Result<Start> find_start(const Scene& scene, const std::optional<TriangleMesh>& obstacle,
                         const StartObserver& observer) {
  auto ribbon = draw_ribbon(scene, obstacle);
  if (!ribbon) return tl::unexpected(ribbon.error());
  if (auto expected = check_expected_knot(scene, *ribbon); !expected)
    return tl::unexpected(expected.error());
  const StartTest is_meant_knot = [&](const Eigen::Matrix3Xd& positions) {
    return check_first_frame(scene, *ribbon, positions).has_value();
  };
  auto fastening = FasteningProcessor::create(scene, *ribbon, obstacle, observer, is_meant_knot);
  if (!fastening) return tl::unexpected(fastening.error());
  if (auto tied = start_is_tied_as_drawn(scene, *ribbon, obstacle, *fastening); !tied)
    return tl::unexpected(tied.error());
  return Start{*std::move(ribbon), *std::move(fastening)};
}

std::optional<CentreAxis> centre_axis(const Scene& scene) {
  if (!scene.fastening) return std::nullopt;
  return CentreAxis{scene.fastening->axis_point_m, scene.fastening->axis_direction};
}

}  // namespace ribbon
