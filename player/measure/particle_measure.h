// Measures what cannot be seen, at every particle of a frame.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "playback/recording_reader.h"
#include "player/measure/quantity.h"
#include "verification/frame_verifier.h"

namespace ribbon {

class ParticleMeasure {
 public:
  // What contact is told by, in this order.
  static constexpr float touches_obstacle = 0;
  static constexpr float touches_nothing = 0.5F;
  static constexpr float touches_ribbon = 1;

  // Keeps a reference to `reader`. Gaps are measured as far as reach_m, and what is as near as that
  // is in contact.
  ParticleMeasure(RecordingReader& reader, Quantity quantity, double reach_m);

  // Of frame `index`, one value per particle of `positions`, which are that frame's:
  // - strain: the largest |length / rest length - 1| of the edges that end there, of those that
  //   the recording's header names (of all where it names none),
  // - speed: mean speed since the frame before (the last one that can be read), in m/s; 0 in the
  //   first frame,
  // - gap: the distance to the next layer or the obstacle, in metres, infinite beyond reach,
  // - contact: which of both is nearer within reach.
  // The same for any number of threads, and whatever was measured before.
  std::vector<float> values(int index, const Eigen::Matrix3Xf& positions);

 private:
  [[nodiscard]] std::vector<float> strains(const Eigen::Matrix3Xf& positions) const;
  std::vector<float> speeds(int index, const Eigen::Matrix3Xf& positions);
  [[nodiscard]] std::vector<float> gaps(const Eigen::Matrix3Xf& positions) const;
  [[nodiscard]] float told(const LayerGap& gap) const;
  // The frame whose positions `before_` then holds, or nothing.
  std::optional<int> load_frame_before(int index);

  RecordingReader& reader_;
  Quantity quantity_;
  double reach_m_;
  std::optional<FrameVerifier> verifier_;  // of gap and contact
  Eigen::Matrix3Xf before_;                // of speed
  std::optional<int> before_index_;
};

}  // namespace ribbon
