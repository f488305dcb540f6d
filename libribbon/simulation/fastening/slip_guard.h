// Is an end of the ribbon about to slip out of its knot?
#pragma once

#include <array>
#include <optional>

#include "simulation/state/state_archive.h"

namespace ribbon {

// Rest lengths from the first and the second end to the nearest row that touches another part of
// the ribbon; nothing where none does.
using LooseEnds = std::array<std::optional<double>, 2>;

class SlipGuard {
 public:
  explicit SlipGuard(double ribbon_width_m) : width_m_(ribbon_width_m) {}

  // Looks at the ends every now and then. An end that becomes shorter than one and a half widths is
  // slipping, if it was not much longer a moment ago: what comes to lie on another part is not.
  void look(const LooseEnds& ends);

  // 0 or 1, once it has been seen.
  [[nodiscard]] std::optional<int> slipping_end() const;

  void visit_memory(StateArchive& archive);

 private:
  double width_m_;
  std::array<double, 2> loose_m_ = {0, 0};  // at the last look
  int slipping_ = -1;
};

}  // namespace ribbon
