#include "simulation/integration/internal_damping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numeric>
#include <utility>

#include "parallel/instruction_set.h"
#include "parallel/parallel.h"

namespace ribbon {

namespace {

using Eigen::Index;
using Eigen::MatrixX3d;

// A lot of so many rows is damped by itself, all lots at a time, and then what leads from one lot
// to the next.
constexpr int rows_in_lot = 32;
constexpr int half_lot = rows_in_lot / 2;

// Of dashpots that have no particle in common several are computed at once: as many as fit one
// register of the baseline of WebAssembly, which is also the widest that it has; elsewhere four, in
// one register or two.
#ifdef __wasm__
constexpr int lane_count = 2;
#else
constexpr int lane_count = 4;
#endif
using Several [[gnu::vector_size(lane_count * sizeof(double))]] = double;

// Do all rows weigh the same?
enum class Rows { alike, differing };

// As the innermost loop needs a family.
template <std::size_t ends, Rows rows>
struct Loop {
  std::array<Index, ends> offsets{};   // from a dashpot's first particle, in the arrays
  std::array<double, ends> lighter{};  // of rows that differ: the weights times their lightness
  double slowed = 0;  // the fraction of the speed that is lost, over sum(w^2 lightness)
  std::array<const double*, 3> positions{};
  std::array<double*, 3> velocities{};

  // The dashpot of the particle at `first`, or those of several from there on.
  template <class Lanes>
  [[gnu::always_inline]] void damp(Index first) const {
    constexpr std::array<double, ends> weights = DashpotFamily::weights<ends>();
    std::array<Lanes, 3> apart{};
    std::array<Lanes, 3> parting{};
    Lanes value{};
    for (std::size_t k = 0; k < ends; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::memcpy(&value, positions[axis] + first + offsets[k], sizeof(value));
        apart[axis] = k == 0 ? weights[k] * value : apart[axis] + weights[k] * value;
        std::memcpy(&value, velocities[axis] + first + offsets[k], sizeof(value));
        parting[axis] = k == 0 ? weights[k] * value : parting[axis] + weights[k] * value;
      }
    const Lanes squared = apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2];
    const Lanes along = apart[0] * parting[0] + apart[1] * parting[1] + apart[2] * parting[2];
    // Points that coincide have no direction, and nothing parts along it.
    const Lanes lost = slowed * along / (squared > 0 ? squared : Lanes{} + 1);
    for (std::size_t k = 0; k < ends; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double* velocity = velocities[axis] + first + offsets[k];
        std::memcpy(&value, velocity, sizeof(value));
        if constexpr (rows == Rows::alike)
          value -= weights[k] * (lost * apart[axis]);
        else
          value -= lighter[k] * lost * apart[axis];
        std::memcpy(velocity, &value, sizeof(value));
      }
  }

  // Those of `count` particles one after the other, which have no particle in common.
  [[gnu::always_inline]] void damp_run(Index first, int count) const {
    int i = 0;
    for (; i + lane_count <= count; i += lane_count) damp<Several>(first + i);
    for (; i < count; ++i) damp<double>(first + i);
  }
};

// How the particles of the arrays lie: row by row as in the grid; or, of one lot, column by column,
// in each the even rows before the odd ones, so that what leads across the ribbon can be computed
// for several rows at once.
enum class Layout { rows, turned };

int turned(int row, int column) {
  return column * rows_in_lot + row % 2 * half_lot + row / 2;
}

// The dashpots of a family whose first particles lie in rows [begin, end); all their ends exist.
struct Task {
  const RibbonGrid& grid;
  const DashpotFamily& family;
  const double* lightness;  // of the rows; null where they weigh the same for this family
  double h;
  Layout layout;
  int begin;
  int end;
  const MatrixX3d& positions;
  MatrixX3d& velocities;
};

double fraction_lost(double rate_per_s, double h) {
  const double r = rate_per_s * h;
  return r < 2 ? r / (1 + r / 2) : 1;
}

// offset_of(end): where an end's particle is in the arrays, from the first.
template <std::size_t ends, Rows rows, class Offset>
[[gnu::always_inline]] inline Loop<ends, rows> loop_of(const Task& task, const Offset& offset_of) {
  Loop<ends, rows> loop;
  for (std::size_t k = 0; k < ends; ++k) loop.offsets[k] = offset_of(task.family.ends[k]);
  loop.slowed = fraction_lost(task.family.rate_per_s, task.h) / task.family.squared_weights;
  for (int axis = 0; axis < 3; ++axis) {
    loop.positions[axis] = task.positions.col(axis).data();
    loop.velocities[axis] = task.velocities.col(axis).data();
  }
  return loop;
}

// What changes from row to row where they weigh differently.
template <std::size_t ends>
void take_row(const Task& task, int row, Loop<ends, Rows::differing>& loop) {
  double squared = 0;
  for (std::size_t k = 0; k < ends; ++k) {
    const double weight = DashpotFamily::weights<ends>()[k];
    loop.lighter[k] = weight * task.lightness[row + task.family.ends[k].rows];
    squared += weight * loop.lighter[k];
  }
  const double faster = std::sqrt(squared / task.family.squared_weights);
  loop.slowed = fraction_lost(faster * task.family.rate_per_s, task.h) / squared;
}

template <std::size_t ends, Rows rows>
[[gnu::always_inline]] inline void damp_rows(const Task& task) {
  auto loop = loop_of<ends, rows>(task, [&](const DashpotFamily::End& end) -> Index {
    return task.grid.particle(end.rows, end.columns);
  });
  const int columns = task.grid.across - task.family.columns;
  const int at_once = task.family.are_apart_in_a_row ? columns : 1;
  for (int row = task.begin; row < task.end; ++row) {
    if constexpr (rows == Rows::differing) take_row(task, row, loop);
    for (int column = 0; column < columns; column += at_once)
      loop.damp_run(task.grid.particle(row, column), at_once);
  }
}

// Column by column, the even rows before the odd ones: of families of one or two rows, whose
// dashpots at every other row are apart.
template <std::size_t ends>
[[gnu::always_inline]] inline void damp_turned(const Task& task) {
  for (int parity = 0; parity < 2; ++parity) {
    const auto loop = loop_of<ends, Rows::alike>(task, [&](const DashpotFamily::End& end) -> Index {
      return turned(parity + end.rows, end.columns) - turned(parity, 0);
    });
    const int count = (task.end - task.begin + 1 - parity) / 2;
    for (int column = 0; column + task.family.columns < task.grid.across; ++column)
      loop.damp_run(turned(parity, column), count);
  }
}

template <std::size_t ends>
[[gnu::always_inline]] inline void damp_with(const Task& task) {
  if (task.layout == Layout::turned)
    damp_turned<ends>(task);
  else if (task.lightness == nullptr)
    damp_rows<ends, Rows::alike>(task);
  else
    damp_rows<ends, Rows::differing>(task);
}

[[gnu::always_inline]] inline void damp_with_any(const Task& task) {
  switch (task.family.ends.size()) {
    case 2:
      return damp_with<2>(task);
    case 3:
      return damp_with<3>(task);
    default:
      return damp_with<4>(task);
  }
}

void plain(const Task& task) {
  damp_with_any(task);
}

#ifdef __x86_64__
[[gnu::target("avx2")]]
#endif
void in_wide_registers(const Task& task) {
  damp_with_any(task);
}

void damp(const Task& task) {
  if (instruction_set() == InstructionSet::baseline)
    plain(task);
  else
    in_wide_registers(task);
}

// between(x, turned_x) for each coordinate of the lot that begins with a row, here and there.
template <class Here, class There, class Between>
void for_each_turned(const RibbonGrid& grid, int first_row, int rows, Here& here, There& there,
                     const Between& between) {
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < grid.across; ++column)
        between(here(grid.particle(first_row + row, column), axis),
                there(turned(row, column), axis));
}

DashpotFamily beside(const SpringFamily& springs) {
  return DashpotFamily(
      {{0, std::max(0, -springs.columns)}, {springs.rows, std::max(0, springs.columns)}});
}

template <std::size_t size>
double squared_norm(const std::array<double, size>& numbers) {
  return std::inner_product(numbers.begin(), numbers.end(), numbers.begin(), 0.0);
}

}  // namespace

DashpotFamily::DashpotFamily(std::vector<End> of_ends) : ends(std::move(of_ends)) {
  for (const End& end : ends) {
    rows = std::max(rows, end.rows);
    columns = std::max(columns, end.columns);
  }
  squared_weights = ends.size() == 2   ? squared_norm(weights<2>())
                    : ends.size() == 3 ? squared_norm(weights<3>())
                                       : squared_norm(weights<4>());
  const auto share_a_row = [](const End& a, const End& b) { return a.rows == b.rows; };
  are_apart_in_a_row = std::adjacent_find(ends.begin(), ends.end(), share_a_row) == ends.end();
}

InternalDamping::InternalDamping(const SpringNetwork& network, double particle_mass_kg,
                                 const Eigen::ArrayXd& lightness)
    : grid_(network.grid), lots_((grid_.along + rows_in_lot - 1) / rows_in_lot) {
  for (Index i = 0; i < lightness.size(); i += grid_.across) lightness_.push_back(lightness[i]);
  const auto add = [&](DashpotFamily family, double stiffness) {
    if (stiffness == 0 || family.rows >= grid_.along || family.columns >= grid_.across) return;
    family.rate_per_s =
        2 * network.damping * std::sqrt(family.squared_weights * stiffness / particle_mass_kg);
    families_.push_back(std::move(family));
  };
  for (const SpringKind* kind : network.kinds())
    for (const SpringFamily& springs : kind->families) add(beside(springs), kind->stiffness);
  const double bend = network.bend.stiffness;
  add(DashpotFamily({{0, 0}, {1, 0}, {2, 0}}), bend);
  add(DashpotFamily({{0, 0}, {0, 1}, {0, 2}}), bend);
  add(DashpotFamily({{0, 0}, {0, 1}, {1, 0}, {1, 1}}), bend);
  for (Lot& lot : lots_) {
    lot.positions.setZero(Index{rows_in_lot} * grid_.across, 3);
    lot.velocities.setZero(Index{rows_in_lot} * grid_.across, 3);
  }
}

void InternalDamping::apply(double h, const MatrixX3d& positions, MatrixX3d& velocities) {
  const auto within = [&](std::size_t begin, std::size_t end) {
    for (std::size_t lot = begin; lot < end; ++lot)
      damp_lot(h, static_cast<int>(lot), positions, velocities);
  };
  parallel_ranges(lots_.size(), 1, within);
  const auto between = [&](std::size_t begin, std::size_t end) {
    for (std::size_t lot = begin; lot < end; ++lot)
      damp_after_lot(h, static_cast<int>(lot), positions, velocities);
  };
  parallel_ranges(lots_.size() - 1, 8, between);
}

const double* InternalDamping::lightness_for(const DashpotFamily& family) const {
  return family.are_apart_in_a_row && !lightness_.empty() ? lightness_.data() : nullptr;
}

void InternalDamping::damp_lot(double h, int lot, const MatrixX3d& positions,
                               MatrixX3d& velocities) {
  const int first_row = lot * rows_in_lot;
  const int rows = std::min(rows_in_lot, grid_.along - first_row);
  for (const DashpotFamily& family : families_)
    if (family.are_apart_in_a_row)
      damp({grid_, family, lightness_for(family), h, Layout::rows, first_row,
            first_row + rows - family.rows, positions, velocities});
  auto& [turned_positions, turned_velocities] = lots_[lot];
  const auto fetch = [](double from, double& to) { to = from; };
  for_each_turned(grid_, first_row, rows, positions, turned_positions, fetch);
  for_each_turned(grid_, first_row, rows, velocities, turned_velocities, fetch);
  for (const DashpotFamily& family : families_)
    if (!family.are_apart_in_a_row)
      damp({grid_, family, nullptr, h, Layout::turned, 0, rows - family.rows, turned_positions,
            turned_velocities});
  for_each_turned(grid_, first_row, rows, velocities, turned_velocities,
                  [](double& to, double from) { to = from; });
}

void InternalDamping::damp_after_lot(double h, int lot, const MatrixX3d& positions,
                                     MatrixX3d& velocities) {
  const int next_row = (lot + 1) * rows_in_lot;
  for (const DashpotFamily& family : families_)
    damp({grid_, family, lightness_for(family), h, Layout::rows, next_row - family.rows,
          std::min(next_row, grid_.along - family.rows), positions, velocities});
}

}  // namespace ribbon
