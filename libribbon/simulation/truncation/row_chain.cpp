#include "simulation/truncation/row_chain.h"

#include <algorithm>
#include <limits>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double none = std::numeric_limits<double>::infinity();
constexpr double nearly_too_long = 0.004;  // of an edge's rest length

std::vector<double> lightness_of_rows(const RestSize& size) {
  std::vector<double> rows(size.grid.along, 1.0);
  const Eigen::ArrayXd of_particles = lightness(size);
  for (int row = 0; row < size.grid.along && of_particles.size() > 0; ++row)
    rows[row] = of_particles[size.grid.particle(row, 0)];
  return rows;
}

}  // namespace

RowChain::RowChain(const RestSize& size, double limit)
    : grid_(size.grid),
      along_(stretch_families(size)[0]),
      limit_(limit),
      touches_(grid_.along, 0),
      longest_(grid_.along - 1),
      slack_(grid_.along - 1),
      cosines_(grid_.along - 1),
      directions_(3, grid_.along - 1),
      tensions_(lightness_of_rows(size)) {
  const std::vector<double> rows = lightness_of_rows(size);
  lightness_ = Eigen::ArrayXd::Map(rows.data(), grid_.along);
}

void RowChain::break_at(std::span<const ContactConstraint> contacts) {
  std::fill(touches_.begin(), touches_.end(), 0);
  for (const ContactConstraint& contact : contacts)
    for (const int vertex : contact.vertices)
      if (vertex < grid_.particle_count()) touches_[grid_.row(vertex)] = 1;
}

bool RowChain::any_too_long(const Matrix3Xd& positions) {
  return with_rest_lengths(along_, [&](const auto& rest_m) {
    bool any = false;
    for (int row = 0; row + 1 < grid_.along; ++row) {
      if (is_broken(row)) continue;
      double most = -none;
      for_each_spring_of_row(grid_, along_, row, [&](int a, int b) {
        const double longest_m = (1 + limit_) * rest_m(a);
        const double excess =
            squared_length_of(positions.col(b) - positions.col(a)) - longest_m * longest_m;
        if (excess > most) longest_[row] = a;
        most = std::max(most, excess);
      });
      any = any || most > 0;
    }
    return any;
  });
}

void RowChain::measure(const Matrix3Xd& positions) {
  for (int row = 0; row + 1 < grid_.along; ++row) {
    slack_[row] = none;
    if (is_broken(row)) continue;
    const int a = longest_[row];
    const Vector3d apart = positions.col(a + grid_.across) - positions.col(a);
    const double length_m = length_of(apart);
    if (length_m == 0) continue;
    directions_.col(row) = apart / length_m;
    slack_[row] = (1 + limit_) * along_.rest_m(a) - length_m;
  }
  for (int row = 0; row + 2 < grid_.along; ++row)
    if (slack_[row] < none && slack_[row + 1] < none)
      cosines_[row] = dot(directions_.col(row), directions_.col(row + 1));
}

// At which links under tension shrink. Does any grow?
bool RowChain::measure_speeds(std::span<const double> tensions, const Matrix3Xd& velocities) {
  const auto mean = [&](int row) -> Vector3d {
    Vector3d sum = Vector3d::Zero();
    for (int column = 0; column < grid_.across; ++column)
      sum += velocities.col(grid_.particle(row, column));
    return sum / grid_.across;
  };
  bool any = false;
  Vector3d here = mean(0);
  for (int row = 0; row + 1 < grid_.along; ++row) {
    const Vector3d next = mean(row + 1);
    slack_[row] = tensions[row] > 0 ? dot(directions_.col(row), here - next) : none;
    any = any || slack_[row] < 0;
    here = next;
  }
  return any;
}

// of_particles: what they have of it grows.
void RowChain::pull(std::span<const double> tensions, Matrix3Xd& of_particles) const {
  const auto add = [&](int row, double by, const auto& direction) {
    const Vector3d all = by * lightness_[row] * direction;
    for (int column = 0; column < grid_.across; ++column)
      of_particles.col(grid_.particle(row, column)) += all;
  };
  for (int row = 0; row + 1 < grid_.along; ++row) {
    if (tensions[row] == 0) continue;
    add(row, tensions[row], directions_.col(row));
    add(row + 1, -tensions[row], directions_.col(row));
  }
}

void RowChain::shorten(Cloth& cloth) {
  if (!any_too_long(cloth.positions)) return;
  measure(cloth.positions);
  const std::span<const double> tensions =
      tensions_.find(slack_, cosines_, nearly_too_long * along_.rest_length_m);
  pull(tensions, cloth.positions);
  if (measure_speeds(tensions, cloth.velocities))
    pull(tensions_.find(slack_, cosines_, 0), cloth.velocities);
}

}  // namespace ribbon
