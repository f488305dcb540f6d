#include "player/measure/particle_measure.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "geometry/limited_edges.h"
#include "parallel/parallel.h"

namespace ribbon {

namespace {

constexpr double nothing_m = std::numeric_limits<double>::infinity();

}  // namespace

ParticleMeasure::ParticleMeasure(RecordingReader& reader, Quantity quantity, double reach_m)
    : reader_(reader), quantity_(quantity), reach_m_(reach_m) {
  const RecordingHeader& header = reader.header();
  if (quantity == Quantity::gap || quantity == Quantity::contact)
    verifier_.emplace(rest_size(header), header.obstacle);
}

std::vector<float> ParticleMeasure::values(int index, const Eigen::Matrix3Xf& positions) {
  assert(positions.cols() == reader_.header().grid.particle_count());
  switch (quantity_) {
    case Quantity::strain:
      return strains(positions);
    case Quantity::speed:
      return speeds(index, positions);
    case Quantity::contact:
    case Quantity::gap:
      break;
  }
  return gaps(positions);
}

std::vector<float> ParticleMeasure::strains(const Eigen::Matrix3Xf& positions) const {
  const RecordingHeader& header = reader_.header();
  return particle_strains(rest_size(header), measured_edges(header.limited_edges), positions);
}

std::optional<int> ParticleMeasure::load_frame_before(int index) {
  int before = index - 1;
  while (before >= 0 && !(reader_.readable(before) && reader_.numbers(before))) --before;
  if (before < 0) return std::nullopt;
  if (before_index_ == before) return before;
  before_index_.reset();
  if (!reader_.read(before, before_)) return std::nullopt;
  return before;
}

std::vector<float> ParticleMeasure::speeds(int index, const Eigen::Matrix3Xf& positions) {
  std::vector<float> speeds(positions.cols(), 0.0F);
  const auto numbers = reader_.numbers(index);
  const auto before = load_frame_before(index);
  if (before && numbers) {
    const double elapsed_s = numbers->time_s - reader_.numbers(*before)->time_s;
    for (Eigen::Index p = 0; p < positions.cols() && elapsed_s > 0; ++p)
      speeds[p] = static_cast<float>(
          (positions.col(p).cast<double>() - before_.col(p).cast<double>()).norm() / elapsed_s);
  }
  // Frames are mostly shown one after the other: so each is decoded once.
  before_ = positions;
  before_index_ = index;
  return speeds;
}

std::vector<float> ParticleMeasure::gaps(const Eigen::Matrix3Xf& positions) const {
  std::vector<float> told_gaps(positions.cols(), told({nothing_m, nothing_m}));
  if (!positions.allFinite()) return told_gaps;
  const LayerGaps gaps = verifier_->layer_gaps(positions);
  parallel_ranges(told_gaps.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      told_gaps[p] = told(gaps.at(static_cast<int>(p), reach_m_));
  });
  return told_gaps;
}

float ParticleMeasure::told(const LayerGap& gap) const {
  const double nearest_m = std::min(gap.to_ribbon_m, gap.to_obstacle_m);
  if (quantity_ == Quantity::gap) return static_cast<float>(nearest_m);
  if (nearest_m > reach_m_) return touches_nothing;
  return gap.to_ribbon_m < gap.to_obstacle_m ? touches_ribbon : touches_obstacle;
}

}  // namespace ribbon
