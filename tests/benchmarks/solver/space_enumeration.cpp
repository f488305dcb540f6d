#include "benchmarks/solver/space_enumeration.h"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace ribbon {

namespace {

using Cell = Eigen::Vector3i;

class Cells {
 public:
  explicit Cells(double size_m) : size_m_(size_m) {}

  [[nodiscard]] Cell at(const Eigen::Vector3d& point) const {
    return (point / size_m_).array().floor().cast<int>();
  }

  // Calls visit(cell) for each cell that `box` reaches into.
  template <class Visit>
  void visit(const Box& box, const Visit& visit) const {
    const Cell low = at(box.low);
    const Cell high = at(box.high);
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z) visit(Cell(x, y, z));
  }

 private:
  double size_m_;
};

std::size_t slot_of(const Cell& cell, std::size_t slots) {
  const auto part = [&](int axis, std::uint64_t factor) {
    return static_cast<std::uint32_t>(cell[axis]) * factor;
  };
  const std::uint64_t mixed =
      part(0, 0x9E3779B97F4A7C15U) ^ part(1, 0xC2B2AE3D27D4EB4FU) ^ part(2, 0x165667B19E3779F9U);
  return (mixed >> 20U) & (slots - 1);
}

struct Entry {
  Cell cell;
  int box = 0;
};

}  // namespace

std::vector<CandidatePair> pairs_by_cells(std::span<const Box> boxes, double cell_m) {
  const Cells cells(cell_m);
  std::size_t entry_count = 0;
  for (const Box& box : boxes) cells.visit(box, [&](const Cell& /*cell*/) { ++entry_count; });

  // Sorted by counting: how many entries each slot has, then where its entries begin, then the
  // entries.
  const std::size_t slots = std::bit_ceil(entry_count + 1);
  std::vector<std::size_t> first(slots + 1, 0);
  for (const Box& box : boxes)
    cells.visit(box, [&](const Cell& cell) { ++first[slot_of(cell, slots) + 1]; });
  for (std::size_t slot = 0; slot < slots; ++slot) first[slot + 1] += first[slot];
  std::vector<Entry> entries(entry_count);
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (std::size_t b = 0; b < boxes.size(); ++b)
    cells.visit(boxes[b], [&](const Cell& cell) {
      entries[next[slot_of(cell, slots)]++] = {cell, static_cast<int>(b)};
    });

  std::vector<CandidatePair> pairs;
  for (std::size_t slot = 0; slot < slots; ++slot)
    for (std::size_t i = first[slot]; i < first[slot + 1]; ++i)
      for (std::size_t j = i + 1; j < first[slot + 1]; ++j) {
        if (entries[i].cell != entries[j].cell) continue;
        const Box& a = boxes[entries[i].box];
        const Box& b = boxes[entries[j].box];
        if (!a.meets(b)) continue;
        // Boxes that share several cells are a pair in the first of them only.
        if (cells.at(a.low.cwiseMax(b.low)) == entries[i].cell)
          pairs.push_back({entries[i].box, entries[j].box});
      }
  return pairs;
}

}  // namespace ribbon
