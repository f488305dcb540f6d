// How restless each particle has been.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "recording/prediction.h"

namespace ribbon {

// One plane per component; a border as in Field, unused.
using Residuals = std::array<Field, 3>;

// How large residuals have been lately at each particle: what was restless will be restless. Both
// sides keep it, so that residuals of different size are packed apart without a word about it.
class Activity {
 public:
  static constexpr int classes = 8;

  explicit Activity(const PaddedGrid& grid);
  void forget();  // before each key frame
  void remember(const Residuals& residuals);
  // The class of a particle's residual: 0 where residuals have been smallest.
  [[nodiscard]] std::size_t expected_class(std::size_t component, std::size_t at) const {
    return class_[component][at];
  }

 private:
  PaddedGrid grid_;
  std::array<std::vector<std::uint16_t>, 3> recent_;
  std::array<std::vector<std::uint8_t>, 3> class_;
};

}  // namespace ribbon
