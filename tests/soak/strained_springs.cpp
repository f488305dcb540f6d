#include "soak/strained_springs.h"

#include <algorithm>
#include <cmath>

#include "ribbon_mesh/springs.h"
#include "simulation/state/edge_strain.h"

namespace ribbon {

namespace {

struct Strained {
  std::size_t count = 0;
  double worst = 0;
};

// Bending springs shorten wherever cloth folds: that is no strain.
template <class Visit>
void for_each_stretch_and_shear_spring(const SpringNetwork& network, const Visit& visit) {
  for (const SpringKind* kind : {&network.stretch, &network.shear})
    for (const SpringFamily& family : kind->families)
      for_each_spring(network.grid, family, [&](int a, int b) { visit(family, a, b); });
}

Strained strained_in(const Eigen::Matrix3Xd& positions, const SpringNetwork& network,
                     double limit) {
  Strained strained;
  for_each_stretch_and_shear_spring(network, [&](const SpringFamily& family, int a, int b) {
    const double strain = std::abs(edge_strain(family, a, b, positions));
    if (strain > limit) ++strained.count;
    strained.worst = std::max(strained.worst, strain);
  });
  return strained;
}

}  // namespace

Result<StrainedSprings> strained_springs(RecordingReader& recording, double limit) {
  const RecordingHeader& header = recording.header();
  const SpringNetwork network =
      spring_network({header.grid, header.ribbon_length_m, header.ribbon_width_m}, {});
  StrainedSprings result{.limit = limit};
  for_each_stretch_and_shear_spring(network,
                                    [&](const SpringFamily&, int, int) { ++result.springs; });
  Eigen::Matrix3Xf positions;
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    if (auto read = recording.read(frame, positions); !read) return tl::unexpected(read.error());
    const Strained strained = strained_in(positions.cast<double>(), network, limit);
    const double share = static_cast<double>(strained.count) / static_cast<double>(result.springs);
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
