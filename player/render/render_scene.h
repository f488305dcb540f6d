// What is to be seen: the ribbon where it is now, and the obstacle.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "player/picture/color.h"
#include "player/picture/color_map.h"
#include "player/render/cloth_colors.h"
#include "player/render/ray_scene.h"
#include "player/render/surface.h"
#include "player/render/surface_points.h"
#include "recording/records/recording.h"

namespace ribbon {

class RenderScene {
 public:
  // The obstacle, if there is one, is there; the ribbon is not yet. With selvages the cloth's
  // thickness is seen there.
  explicit RenderScene(const RecordingHeader& header, bool with_selvages = false);

  void set_cloth(ClothColors cloth) { cloth_ = std::move(cloth); }
  // An endless floor at that height, which must be below everything.
  void set_ground(float height_m) { ground_m_ = height_m; }

  // positions: 3 x particles, in metres of the model. half_thickness_m: of the cloth at each
  // particle; needed with selvages. Only a ribbon that has a tree can have it refitted.
  void set_ribbon(const Eigen::Matrix3Xf& positions,
                  const std::vector<float>& half_thickness_m = {},
                  RibbonTree tree = RibbonTree::rebuilt);

  // Shows numbers on the ribbon, on both sides, instead of its cloth: where each particle is on the
  // map, 0 to 1. In between places are interpolated, not colours, so that all are on the map.
  void color_ribbon(const std::vector<float>& places, const ColorMap& map);

  [[nodiscard]] const Surface& ribbon() const { return ribbon_; }
  [[nodiscard]] const Surface& obstacle() const { return obstacle_; }  // empty if there is none
  [[nodiscard]] const RayScene& rays() const { return rays_; }
  void log_rays_to(RayLog* log) { rays_.log_to(log); }
  [[nodiscard]] bool has_ground() const { return ground_m_.has_value(); }
  // Adds the place of the floor that ray `lane`, which met nothing else, leads to; false where it
  // leads to none. Its albedo is left open.
  bool add_ground(const RayBatch& rays, std::size_t lane, SurfaceBatch& batch) const;
  // Adds what the listed rays met, which must be `body`, ribbon or obstacle, to `batch`.
  void add_points(Body body, const RayBatch& rays, const HitBatch& hits, const MarkedLanes& list,
                  SurfaceBatch& batch) const;

 private:
  void set_ribbon_colors(const HitBatch& hits, const MarkedLanes& list, LookBatch& looks,
                         SurfaceBatch& batch) const;

  RibbonGrid grid_;
  bool with_selvages_;
  ClothColors cloth_;
  std::optional<ColorMap> map_;  // on which the ribbon's texture is; none: cloth is shown
  std::optional<float> ground_m_;
  Surface ribbon_;
  Surface obstacle_;
  // The ribbon, then the obstacle. The ribbon's texture: along and across in ribbon widths, or x is
  // on the map.
  HitSurface bodies_;
  RayScene rays_;
  float obstacle_reach_ = 0;  // largest coordinate
  float clearance_ = 0;       // by which light starts above a facet
};

}  // namespace ribbon
