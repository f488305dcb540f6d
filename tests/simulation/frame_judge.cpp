#include "simulation/frame_judge.h"

#include "verification/frame_verifier.h"

namespace ribbon {

struct FrameJudge::Hidden {
  FrameVerifier verifier;
};

FrameJudge::FrameJudge(const RibbonMesh& ribbon, const std::optional<TriangleMesh>& obstacle)
    : hidden_(std::make_unique<Hidden>(Hidden{FrameVerifier(ribbon.size(), obstacle)})) {}
FrameJudge::FrameJudge(FrameJudge&&) noexcept = default;
FrameJudge& FrameJudge::operator=(FrameJudge&&) noexcept = default;
FrameJudge::~FrameJudge() = default;

bool FrameJudge::is_free(const Eigen::Matrix3Xd& positions) const {
  const FrameVerdict verdict = hidden_->verifier.verify(positions.cast<float>());
  return verdict.finite && verdict.intersections.pairs.empty();
}

double FrameJudge::gap_m(const Eigen::Matrix3Xd& positions) const {
  return hidden_->verifier.verify(positions.cast<float>()).gap.certain_m;
}

}  // namespace ribbon
