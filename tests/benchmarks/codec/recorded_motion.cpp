#include "benchmarks/codec/recorded_motion.h"

#include <algorithm>

#include "playback/recording_reader.h"

namespace ribbon {

double RecordedMotion::largest_m() const {
  double largest_m = 0;
  for (const Eigen::Matrix3Xf& frame : frames)
    largest_m = std::max<double>(largest_m, frame.cwiseAbs().maxCoeff());
  return largest_m;
}

double RecordedMotion::start_m() const {
  return frames.front().cwiseAbs().maxCoeff();
}

double RecordedMotion::quantisation_step_m(double bound_m) const {
  return ribbon::quantisation_step_m(bound_m, start_m(), header.ribbon_length_m);
}

Result<RecordedMotion> read_motion(const std::filesystem::path& path) {
  auto reader = RecordingReader::open(path);
  if (!reader) return tl::unexpected(reader.error());
  RecordedMotion motion{reader->header(), {}, {}};
  for (int i = 0; i < reader->frame_count(); ++i) {
    motion.frames.emplace_back();
    if (auto read = reader->read(i, motion.frames.back()); !read)
      return tl::unexpected(read.error());
    motion.numbers.push_back(reader->numbers(i).value());
  }
  return motion;
}

}  // namespace ribbon
