#include "benchmarks/codec/own_codec.h"

#include <cassert>
#include <cstdint>

#include "recording/codec/position_decoder.h"
#include "recording/codec/position_encoder.h"
#include "recording/writer/compact_encoder.h"
#include "recording/writer/references.h"

namespace ribbon {

namespace {

// In which order the frames of a group are encoded, and from which others each is predicted.
struct Profile {
  std::vector<PlannedFrame> (*plan)(std::uint32_t frames);
  bool compacts = false;  // frames that were recorded before, in the smallest of several ways
};

CodecParameters parameters_of(const CodecTask& task) {
  RecordingHeader header = task.header;
  header.max_position_error_m = task.bound_m;
  header.quantisation_step_m =
      quantisation_step_m(task.bound_m, task.start_m, header.ribbon_length_m);
  return codec_parameters(header);
}

class OwnCodec : public FrameCodec {
 public:
  OwnCodec(const CodecTask& task, const Profile& profile)
      : profile_(profile),
        encoder_(parameters_of(task), task.bound_m),
        compact_encoder_(parameters_of(task), task.bound_m),
        decoder_(parameters_of(task)) {}

  void take(FrameSpan frames) override {
    positions_.clear();
    recorded_.clear();
    for (const Eigen::Matrix3Xf& frame : frames) positions_.emplace_back(frame.cast<double>());
    if (profile_.compacts)
      for (const Eigen::Matrix3Xd& frame : positions_)
        recorded_.push_back(encoder_.rounded(frame).value());
    plan_ = profile_.plan(static_cast<std::uint32_t>(frames.size()));
    encoded_.resize(frames.size());
    decoded_frames_.resize(frames.size());
    decoded_positions_.assign(frames.begin(), frames.end());
    for (Eigen::Matrix3Xf& frame : decoded_positions_) frame.setZero();
  }

  std::size_t encode() override {
    std::size_t bytes = 0;
    for (const PlannedFrame& planned : plan_) {
      CompactedFrame& encoded = encoded_[planned.frame];
      encoded = profile_.compacts ? compacted(planned) : live(planned);
      bytes += encoded.encoded.geometry.size();
    }
    return bytes;
  }

  void decode() override {
    for (const PlannedFrame& planned : plan_) {
      const auto& [encoded, needed] = encoded_[planned.frame];
      QuantisedFrame& frame = decoded_frames_[planned.frame];
      const auto references = frames_of(
          needed, [this](std::uint32_t reference) { return &decoded_frames_[reference]; });
      [[maybe_unused]] const bool is_valid =
          decoder_.decode(encoded.encoding, encoded.geometry, references, frame);
      assert(is_valid);
      frame.positions(decoded_positions_[planned.frame]);
    }
  }

  [[nodiscard]] Eigen::Matrix3Xf decoded(int index) const override {
    return decoded_positions_[index];
  }

 private:
  CompactedFrame live(const PlannedFrame& planned) {
    const auto references = frames_of(planned.references, [this](std::uint32_t reference) {
      return &encoded_[reference].encoded.frame;
    });
    return {encoder_.encode(positions_[planned.frame], references).value(), planned.references};
  }

  CompactedFrame compacted(const PlannedFrame& planned) {
    return compact_encoder_.encode(
        recorded_[planned.frame], planned.references,
        [this](std::uint32_t reference) { return &recorded_[reference]; });
  }

  Profile profile_;
  PositionEncoder encoder_;
  CompactEncoder compact_encoder_;
  PositionDecoder decoder_;
  std::vector<Eigen::Matrix3Xd> positions_;
  std::vector<QuantisedFrame> recorded_;  // to be compacted
  std::vector<PlannedFrame> plan_;
  std::vector<CompactedFrame> encoded_;
  std::vector<QuantisedFrame> decoded_frames_;
  std::vector<Eigen::Matrix3Xf> decoded_positions_;
};

CodecRow row(const std::string& name, const Profile& profile, std::uint32_t group_frames) {
  return {.name = name,
          .settings = {[=](const CodecTask& task) -> std::unique_ptr<FrameCodec> {
            return std::make_unique<OwnCodec>(task, profile);
          }},
          .group_frames = static_cast<int>(group_frames)};
}

std::vector<PlannedFrame> live_plan(std::uint32_t frames) {
  std::vector<PlannedFrame> plan(frames);
  for (std::uint32_t frame = 0; frame < frames; ++frame)
    plan[frame] = {frame, live_references(frame)};
  return plan;
}

}  // namespace

std::vector<CodecRow> own_rows() {
  return {row("ribbon, live", {live_plan}, live_group_frames),
          // A block is two of its groups, which share the frame between them.
          row("ribbon, compacted", {compaction_plan, true}, block_frames)};
}

}  // namespace ribbon
