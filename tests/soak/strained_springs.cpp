#include "soak/strained_springs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ribbon_mesh/springs.h"

namespace ribbon {

namespace {

struct Strained {
  std::size_t count = 0;
  double worst = 0;
};

// Bending springs shorten wherever cloth folds: that is no strain.
std::vector<Spring> stretch_and_shear(const RecordingHeader& header) {
  const SpringNetwork network =
      spring_network(header.grid, header.ribbon_length_m, header.ribbon_width_m,
                     {.stretch = 1, .shear = 1, .bend = 0});
  std::vector<Spring> springs = network.stretch.springs;
  springs.insert(springs.end(), network.shear.springs.begin(), network.shear.springs.end());
  return springs;
}

Strained strained_in(const Eigen::Matrix3Xf& positions, const std::vector<Spring>& springs,
                     double limit) {
  Strained strained;
  for (const Spring& spring : springs) {
    const double length_m =
        (positions.col(spring.b).cast<double>() - positions.col(spring.a).cast<double>()).norm();
    const double elongation = length_m / spring.rest_length_m - 1;
    if (std::abs(elongation) > limit) ++strained.count;
    strained.worst = std::max(strained.worst, std::abs(elongation));
  }
  return strained;
}

}  // namespace

Result<StrainedSprings> strained_springs(RecordingReader& recording, double limit) {
  const std::vector<Spring> springs = stretch_and_shear(recording.header());
  StrainedSprings result{.springs = springs.size(), .limit = limit};
  Eigen::Matrix3Xf positions;
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    if (auto read = recording.read(frame, positions); !read) return tl::unexpected(read.error());
    const Strained strained = strained_in(positions, springs, limit);
    const double share = static_cast<double>(strained.count) / static_cast<double>(springs.size());
    result.mean_share += share / recording.frame_count();
    result.last_share = share;
    if (share > result.worst_share) {
      result.worst_share = share;
      result.worst_share_frame = frame + 1;
    }
    if (strained.worst > result.worst_elongation) {
      result.worst_elongation = strained.worst;
      result.worst_frame = frame + 1;
    }
  }
  return result;
}

}  // namespace ribbon
