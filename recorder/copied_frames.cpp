#include "recorder/copied_frames.h"

#include <cstring>

namespace ribbon {

namespace {

bool same_bits(const Eigen::Matrix3Xf& a, const Eigen::Matrix3Xf& b) {
  return a.cols() == b.cols() && std::memcmp(a.data(), b.data(), sizeof(float) * a.size()) == 0;
}

}  // namespace

std::optional<int> first_lost_frame(RecordingReader& reader, int count) {
  reader.check();
  for (int frame = 0; frame < count; ++frame)
    if (!reader.readable(frame) || !reader.numbers(frame)) return frame;
  return std::nullopt;
}

bool same_frame(RecordingReader& a, RecordingReader& b, int frame) {
  Eigen::Matrix3Xf in_a;
  Eigen::Matrix3Xf in_b;
  return a.read(frame, in_a) && b.read(frame, in_b) && same_bits(in_a, in_b) &&
         a.numbers(frame) == b.numbers(frame);
}

}  // namespace ribbon
