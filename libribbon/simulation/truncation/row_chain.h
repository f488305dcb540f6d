// The parts of the ribbon that touch nothing, as chains of rows.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/rest_size.h"
#include "ribbon_mesh/springs.h"
#include "simulation/state/cloth.h"
#include "simulation/truncation/chain_tensions.h"
#include "simulation/truncation/contact_constraints.h"

namespace ribbon {

// Sweeps pass tension on from row to row, so a long end that is pulled hard needs as many as the
// square of its rows. Where nothing is in the way they can be spared: the tensions between whole
// rows that hold them together are found at once. Rows that touch something are left to the
// sweeps, where contact has its say. Keeps its memory.
class RowChain {
 public:
  // limit: by which part of their rest length edges along the ribbon may be longer, above 0.
  RowChain(const RestSize& size, double limit);

  // From now on the chain ends at the rows of these.
  void break_at(std::span<const ContactConstraint> contacts);

  // Where an edge along the ribbon is too long, moves rows as wholes, along their longest edges
  // and by as little as brings all links back to the limit, and takes from them the speed at which
  // links under tension would grow. Momentum is kept, and kinetic energy never grows.
  void shorten(Cloth& cloth);

 private:
  [[nodiscard]] bool any_too_long(const Eigen::Matrix3Xd& positions);
  void measure(const Eigen::Matrix3Xd& positions);
  bool measure_speeds(std::span<const double> tensions, const Eigen::Matrix3Xd& velocities);
  void pull(std::span<const double> tensions, Eigen::Matrix3Xd& rows) const;
  [[nodiscard]] bool is_broken(int row) const { return touches_[row] + touches_[row + 1] > 0; }

  RibbonGrid grid_;
  SpringFamily along_;
  double limit_;
  Eigen::ArrayXd lightness_;   // of the rows: the mean mass over theirs
  std::vector<char> touches_;  // does a row?
  std::vector<int> longest_;   // the first particle of the longest edge from each row to the next
  std::vector<double> slack_;  // of the links, m or m/s
  std::vector<double> cosines_;
  Eigen::Matrix3Xd directions_;
  ChainTensions tensions_;
};

}  // namespace ribbon
