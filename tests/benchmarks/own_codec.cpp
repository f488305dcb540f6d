#include "benchmarks/own_codec.h"

#include <cassert>
#include <cstdint>

#include "recording/position_decoder.h"
#include "recording/position_encoder.h"
#include "recording/references.h"

namespace ribbon {

namespace {

// In which order the frames of a group are encoded, and from which others each is predicted.
struct Profile {
  // The frame of the group that is encoded at `turn`, for a group of `frames`.
  std::uint32_t (*frame_at)(std::uint32_t turn, std::uint32_t frames);
  std::vector<std::uint32_t> (*references)(std::uint32_t frame);
};

CodecParameters parameters_of(const CodecTask& task) {
  RecordingHeader header = task.header;
  header.max_position_error_m = task.bound_m;
  header.lattice_step_m = lattice_step_m(task.bound_m, task.start_m, header.ribbon_length_m);
  return codec_parameters(header);
}

class OwnCodec : public FrameCodec {
 public:
  OwnCodec(const CodecTask& task, const Profile& profile)
      : profile_(profile),
        encoder_(parameters_of(task), task.bound_m),
        decoder_(parameters_of(task)) {}

  void take(FrameSpan frames) override {
    positions_.clear();
    for (const Eigen::Matrix3Xf& frame : frames) positions_.emplace_back(frame.cast<double>());
    encoded_.resize(frames.size());
    lattice_.resize(frames.size());
    decoded_.assign(frames.begin(), frames.end());
    for (Eigen::Matrix3Xf& frame : decoded_) frame.setZero();
  }

  std::size_t encode() override {
    std::size_t bytes = 0;
    for (std::uint32_t turn = 0; turn < count(); ++turn) {
      const std::uint32_t frame = profile_.frame_at(turn, count());
      const auto references = references_of(
          frame, [this](std::uint32_t reference) { return &encoded_[reference].frame; });
      encoded_[frame] = encoder_.encode(positions_[frame], references).value();
      bytes += encoded_[frame].geometry.size();
    }
    return bytes;
  }

  void decode() override {
    for (std::uint32_t turn = 0; turn < count(); ++turn) {
      const std::uint32_t frame = profile_.frame_at(turn, count());
      const auto references =
          references_of(frame, [this](std::uint32_t reference) { return &lattice_[reference]; });
      [[maybe_unused]] const bool is_valid = decoder_.decode(
          encoded_[frame].encoding, encoded_[frame].geometry, references, lattice_[frame]);
      assert(is_valid);
      lattice_[frame].positions(decoded_[frame]);
    }
  }

  [[nodiscard]] Eigen::Matrix3Xf decoded(int index) const override {
    return decoded_[static_cast<std::size_t>(index)];
  }

 private:
  [[nodiscard]] std::uint32_t count() const {
    return static_cast<std::uint32_t>(positions_.size());
  }

  template <class Lattice>
  [[nodiscard]] std::vector<const LatticeFrame*> references_of(std::uint32_t frame,
                                                               const Lattice& lattice) const {
    std::vector<const LatticeFrame*> references;
    for (const std::uint32_t reference : profile_.references(frame))
      references.push_back(lattice(reference));
    return references;
  }

  Profile profile_;
  PositionEncoder encoder_;
  PositionDecoder decoder_;
  std::vector<Eigen::Matrix3Xd> positions_;
  std::vector<EncodedFrame> encoded_;
  std::vector<LatticeFrame> lattice_;
  std::vector<Eigen::Matrix3Xf> decoded_;
};

CodecRow row(const std::string& name, const Profile& profile, std::uint32_t group_frames) {
  return {.name = name,
          .settings = {[=](const CodecTask& task) -> std::unique_ptr<FrameCodec> {
            return std::make_unique<OwnCodec>(task, profile);
          }},
          .group_frames = static_cast<int>(group_frames)};
}

std::uint32_t in_time(std::uint32_t turn, std::uint32_t /*frames*/) {
  return turn;
}

}  // namespace

std::vector<CodecRow> own_rows() {
  return {row("ribbon, live", {in_time, live_references}, live_group_frames)};
}

}  // namespace ribbon
