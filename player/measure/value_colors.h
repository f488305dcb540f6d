// Measured values as colours.
#pragma once

#include <optional>
#include <vector>

#include "player/measure/particle_measure.h"
#include "player/picture/legend.h"

namespace ribbon {

class ValueColors {
 public:
  // Keeps a reference to `reader`. Where `chosen` is empty the range is
  // - of strain and speed, from 0 to the largest value in `frames` (indices from 0, all readable),
  // - of gap, from 0 to a tenth of the ribbon's width,
  // - of contact, from 0 to 0.4 of the distance of the nearest particles at rest, which is where
  //   layers of cloth without thickness rest on each other.
  // Fails when a frame cannot be read.
  static Result<ValueColors> create(RecordingReader& reader, Quantity quantity,
                                    const std::optional<ValueRange>& chosen,
                                    const std::vector<int>& frames);

  [[nodiscard]] const ColorMap& map() const { return map_; }
  // Where on the map the particles are in frame `index`, whose positions these are.
  std::vector<float> places(int index, const Eigen::Matrix3Xf& positions);
  [[nodiscard]] Legend legend() const;

 private:
  ValueColors(RecordingReader& reader, Quantity quantity, const ValueRange& range, bool chosen);
  [[nodiscard]] float place(double value) const;

  Quantity quantity_;
  ValueRange range_;
  bool is_chosen_;  // not by us: there may be values beyond it
  ColorMap map_;
  ParticleMeasure measure_;
};

}  // namespace ribbon
