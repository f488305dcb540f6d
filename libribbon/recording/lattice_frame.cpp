#include "recording/lattice_frame.h"

#include <cmath>
#include <utility>

#include "recording/component_loops.h"

namespace ribbon {

namespace {

// What lies one beyond the end of a straight line through the last two.
void continue_over_border(const ParityPlanes& planes, std::vector<float>& values) {
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
  // Every second row lies one stride further on.
  const auto stride = static_cast<std::size_t>(planes.stride());
  for (const int first : {-1, 0})
    for (const auto& [j, dj] : {std::pair{-1, 1}, {across, -1}}) {
      std::size_t to = planes.cell_of(first, j);
      std::size_t near = planes.cell_of(first, j + dj);
      std::size_t far = planes.cell_of(first, j + 2 * dj);
      for (int i = first; i <= along; i += 2, to += stride, near += stride, far += stride)
        values[to] = 2 * values[near] - values[far];
    }
}

}  // namespace

void LatticeFrame::positions(Eigen::Matrix3Xf& positions) const {
  if (plain) {
    positions = plain_positions;
    return;
  }
  positions.resize(3, grid.particle_count());
  loops().positions(ParityPlanes(grid), {numbers[0].data(), numbers[1].data(), numbers[2].data()},
                    step_m, positions.data());
}

void LatticeFrame::set_values() {
  for (std::size_t c = 0; c < 3; ++c) {
    values[c].resize(numbers[c].size());
    for (std::size_t cell = 0; cell < values[c].size(); ++cell)
      values[c][cell] =
          step_m > 0 ? static_cast<float>(numbers[c][cell]) : from_ordered_number(numbers[c][cell]);
  }
  continue_values();
}

void LatticeFrame::continue_values() {
  const ParityPlanes planes(grid);
  for (auto& component : values) continue_over_border(planes, component);
}

bool LatticeFrame::is_finite() const {
  if (step_m > 0) return true;
  const ParityPlanes planes(grid);
  bool finite = true;
  for (const auto& component : values)
    for (int i = 0; i < grid.along; ++i)
      for (int j = 0; j < grid.across; ++j)
        finite = finite && std::isfinite(component[planes.cell_of(i, j)]);
  return finite;
}

std::span<const LatticeFrame* const> usable(std::span<const LatticeFrame* const> references) {
  std::size_t count = 0;
  while (count < references.size() && !references[count]->plain) ++count;
  return references.first(count);
}

}  // namespace ribbon
