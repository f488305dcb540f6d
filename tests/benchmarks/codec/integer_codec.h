// Codecs of integers put to work on floats: quantisation, differences in time, and the codec.
#pragma once

#include <cstdint>

#include "benchmarks/codec/float_group.h"
#include "benchmarks/codec/integers.h"

namespace ribbon {

class IntegerCodec : public FrameCodec {
 public:
  // step: as of quantisation_step().
  IntegerCodec(Layout layout, float step, TimeDifference difference, SignForm sign)
      : floats_(layout), step_(step), form_{0, difference, sign} {}

  void take(FrameSpan frames) override {
    floats_.take(frames);
    form_.frame_values = floats_.frame_values();
    integers_.resize(floats_.values().size());
    residuals_.resize(floats_.values().size());
  }

  std::size_t encode() override {
    to_integers(floats_.values(), step_, integers_);
    to_residuals(integers_, form_, residuals_);
    return pack(residuals_);
  }

  void decode() override {
    unpack(residuals_);
    undo_residuals(residuals_, form_, integers_);
    to_floats(integers_, step_, floats_.decoded());
  }

  [[nodiscard]] Eigen::Matrix3Xf decoded(int index) const override {
    return floats_.decoded(index);
  }

 protected:
  [[nodiscard]] std::size_t frame_values() const { return form_.frame_values; }

 private:
  // Whole frames of residuals to bytes that are kept (their number), and back.
  virtual std::size_t pack(std::span<const std::uint32_t> residuals) = 0;
  virtual void unpack(std::span<std::uint32_t> residuals) = 0;

  FloatGroup floats_;
  float step_;
  ResidualForm form_;
  std::vector<std::uint32_t> integers_;
  std::vector<std::uint32_t> residuals_;
};

// Settings for all ways to take differences in time; Codec(task, step, difference, sign).
template <class Codec, class... Rest>
std::vector<CodecRow::Make> integer_settings(Rest... rest) {
  std::vector<CodecRow::Make> settings;
  for (const TimeDifference difference :
       {TimeDifference::none, TimeDifference::first, TimeDifference::second})
    for (const SignForm sign : {SignForm::zigzag, SignForm::biased})
      settings.push_back([=](const CodecTask& task) -> std::unique_ptr<FrameCodec> {
        const auto step = quantisation_step(task);
        if (!step) return nullptr;
        return std::make_unique<Codec>(*step, difference, sign, rest...);
      });
  return settings;
}

}  // namespace ribbon
