#include "benchmarks/codec/own_codec.h"

#include <cassert>
#include <cstdint>

#include "recording/codec/position_decoder.h"
#include "recording/codec/position_encoder.h"
#include "recording/writer/recording_writer.h"

namespace ribbon {

namespace {

CodecParameters parameters_of(const CodecTask& task) {
  RecordingHeader header = task.header;
  header.max_position_error_m = task.bound_m;
  header.quantisation_step_m =
      quantisation_step_m(task.bound_m, task.start_m, header.ribbon_length_m);
  return codec_parameters(header);
}

class OwnCodec : public FrameCodec {
 public:
  explicit OwnCodec(const CodecTask& task)
      : encoder_(parameters_of(task), task.bound_m), decoder_(parameters_of(task)) {}

  void take(FrameSpan frames) override {
    positions_.clear();
    for (const Eigen::Matrix3Xf& frame : frames) positions_.emplace_back(frame.cast<double>());
    encoded_.resize(frames.size());
    decoded_frames_.resize(frames.size());
    decoded_positions_.assign(frames.begin(), frames.end());
    for (Eigen::Matrix3Xf& frame : decoded_positions_) frame.setZero();
  }

  std::size_t encode() override {
    std::size_t bytes = 0;
    for (std::uint32_t frame = 0; frame < encoded_.size(); ++frame) {
      const auto reference = reference_of(frame);
      encoded_[frame] =
          encoder_.encode(positions_[frame], reference ? &encoded_[*reference].frame : nullptr)
              .value();
      bytes += encoded_[frame].geometry.size();
    }
    return bytes;
  }

  void decode() override {
    for (std::uint32_t frame = 0; frame < encoded_.size(); ++frame) {
      const auto reference = reference_of(frame);
      [[maybe_unused]] const bool is_valid = decoder_.decode(
          encoded_[frame].encoding, encoded_[frame].geometry,
          reference ? &decoded_frames_[*reference] : nullptr, decoded_frames_[frame]);
      assert(is_valid);
      decoded_frames_[frame].positions(decoded_positions_[frame]);
    }
  }

  [[nodiscard]] Eigen::Matrix3Xf decoded(int index) const override {
    return decoded_positions_[index];
  }

 private:
  PositionEncoder encoder_;
  PositionDecoder decoder_;
  std::vector<Eigen::Matrix3Xd> positions_;
  std::vector<EncodedFrame> encoded_;
  std::vector<QuantisedFrame> decoded_frames_;
  std::vector<Eigen::Matrix3Xf> decoded_positions_;
};

}  // namespace

CodecRow own_row() {
  return {.name = "ribbon", .settings = {[](const CodecTask& task) -> std::unique_ptr<FrameCodec> {
                              return std::make_unique<OwnCodec>(task);
                            }}};
}

}  // namespace ribbon
