#include "recording/codec/quantised_frame.h"

#include <cmath>
#include <utility>

#include "recording/codec/frame_loops.h"

namespace ribbon {

namespace {

// What lies one beyond the end of a straight line through the last two.
void continue_over_border(const PolyphasePlanes& planes, std::vector<float>& values) {
  const int along = planes.grid().along;
  const int across = planes.grid().across;
  const auto continued = [&](int i, int j, int di, int dj) {
    values[planes.cell_of(i, j)] =
        2 * values[planes.cell_of(i + di, j + dj)] - values[planes.cell_of(i + 2 * di, j + 2 * dj)];
  };
  for (int j = 0; j < across; ++j) {
    continued(-1, j, 1, 0);
    continued(along, j, -1, 0);
  }
  for (const int first : {0, 1})
    for (const auto& [j, dj] : {std::pair{-1, 1}, {across, -1}}) {
      float* to = &values[planes.cell_of(first, j)];
      const float* near = &values[planes.cell_of(first, j + dj)];
      const float* far = &values[planes.cell_of(first, j + 2 * dj)];
      for (int a = 0; a < planes.rows(2 * first); ++a) to[a] = 2 * near[a] - far[a];
    }
}

}  // namespace

void QuantisedFrame::positions(Eigen::Matrix3Xf& positions) const {
  if (plain) {
    positions = plain_positions;
    return;
  }
  positions.resize(3, grid.particle_count());
  loops().positions(PolyphasePlanes(grid), {values[0].data(), values[1].data(), values[2].data()},
                    step_m > 0 ? step_m : 1, positions.data());
}

void QuantisedFrame::continue_values() {
  const PolyphasePlanes planes(grid);
  for (auto& component : values) continue_over_border(planes, component);
}

bool QuantisedFrame::is_finite() const {
  if (step_m > 0) return true;
  const PolyphasePlanes planes(grid);
  bool finite = true;
  for (const auto& component : values)
    for (int i = 0; i < grid.along; ++i)
      for (int j = 0; j < grid.across; ++j)
        finite = finite && std::isfinite(component[planes.cell_of(i, j)]);
  return finite;
}

std::span<const QuantisedFrame* const> usable(std::span<const QuantisedFrame* const> references) {
  std::size_t count = 0;
  while (count < references.size() && !references[count]->plain) ++count;
  return references.first(count);
}

}  // namespace ribbon
