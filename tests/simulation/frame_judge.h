// The exact verification of single frames, which knows nothing of the gate.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "geometry/triangle_mesh.h"
#include "ribbon_mesh/ribbon_mesh.h"

namespace ribbon {

class FrameJudge {
 public:
  FrameJudge(const RibbonMesh& ribbon, const std::optional<TriangleMesh>& obstacle);
  FrameJudge(FrameJudge&&) noexcept;
  FrameJudge& operator=(FrameJudge&&) noexcept;
  ~FrameJudge();

  // Are the positions (3 x particles) finite, and does nothing meet once they are rounded to single
  // precision?
  [[nodiscard]] bool is_free(const Eigen::Matrix3Xd& positions) const;

  // No gap between features that share no vertex is smaller; 0 where something meets.
  [[nodiscard]] double gap_m(const Eigen::Matrix3Xd& positions) const;

 private:
  struct Hidden;
  std::unique_ptr<Hidden> hidden_;
};

}  // namespace ribbon
