#include "playback/between_frames.h"

#include <cassert>

namespace ribbon {

Result<void> BetweenFrames::read(int index, double after, Eigen::Matrix3Xf& positions) {
  assert(after >= 0 && after < 1);
  if (after == 0) return reader_.read(index, positions);
  const auto begin = frame(index);
  if (!begin) return tl::unexpected(begin.error());
  const auto end = frame(index + 1);
  if (!end) return tl::unexpected(end.error());
  Eigen::Matrix3Xf straight_back;
  Eigen::Matrix3Xf straight_on;
  const Eigen::Matrix3Xf& before = frame_or_beyond(index - 1, **end, **begin, straight_back);
  const Eigen::Matrix3Xf& beyond = frame_or_beyond(index + 2, **begin, **end, straight_on);
  const double t = after;
  const double u = 1 - t;
  const auto weight = [](double number) { return static_cast<float>(number); };
  positions = weight(-t * u * u / 2) * before + weight(u * (1 + t - 1.5 * t * t)) * **begin +
              weight(t * (1 + u - 1.5 * u * u)) * **end + weight(-u * t * t / 2) * beyond;
  return {};
}

Result<const Eigen::Matrix3Xf*> BetweenFrames::frame(int index) {
  Kept& kept = kept_[static_cast<std::size_t>(index) % kept_.size()];
  if (kept.index != index) {
    kept.index = -1;
    if (auto read = reader_.read(index, kept.positions); !read) return tl::unexpected(read.error());
    kept.index = index;
  }
  return &kept.positions;
}

const Eigen::Matrix3Xf& BetweenFrames::frame_or_beyond(int index, const Eigen::Matrix3Xf& before,
                                                       const Eigen::Matrix3Xf& end,
                                                       Eigen::Matrix3Xf& straight_on) {
  if (index >= 0 && index < reader_.frame_count() && reader_.readable(index))
    if (const auto there = frame(index)) return **there;
  straight_on = 2 * end - before;
  return straight_on;
}

}  // namespace ribbon
