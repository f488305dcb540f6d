// The coordinates of a group of frames in one array.
#pragma once

#include <vector>

#include "benchmarks/codec/frame_codec.h"

namespace ribbon {

// planar: all x of a frame, then y, then z; interleaved: x, y, z of each particle.
enum class Layout { planar, interleaved };

class FloatGroup {
 public:
  explicit FloatGroup(Layout layout) : layout_(layout) {}

  void take(FrameSpan frames) {
    particles_ = frames.front().cols();
    frames_ = static_cast<int>(frames.size());
    values_.clear();
    for (const Eigen::Matrix3Xf& frame : frames) {
      const Eigen::MatrixXf columns =
          layout_ == Layout::planar ? Eigen::MatrixXf(frame.transpose()) : Eigen::MatrixXf(frame);
      values_.insert(values_.end(), columns.data(), columns.data() + columns.size());
    }
    decoded_.assign(values_.size(), 0.0F);
  }

  [[nodiscard]] int frames() const { return frames_; }
  [[nodiscard]] std::size_t frame_values() const { return 3 * particles_; }
  [[nodiscard]] std::vector<float>& values() { return values_; }
  // Where decode() of a codec writes to.
  [[nodiscard]] std::vector<float>& decoded() { return decoded_; }

  [[nodiscard]] Eigen::Matrix3Xf decoded(int index) const {
    const float* frame = decoded_.data() + frame_values() * index;
    if (layout_ == Layout::interleaved)
      return Eigen::Map<const Eigen::Matrix3Xf>(frame, 3, particles_);
    return Eigen::Map<const Eigen::MatrixX3f>(frame, particles_, 3).transpose();
  }

 private:
  Layout layout_;
  Eigen::Index particles_ = 0;
  int frames_ = 0;
  std::vector<float> values_;
  std::vector<float> decoded_;
};

}  // namespace ribbon
