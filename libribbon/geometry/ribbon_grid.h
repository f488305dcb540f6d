// The particles of a ribbon: a grid of `along` rows, each `across` particles wide.
#pragma once

#include <Eigen/Core>
#include <array>

namespace ribbon {

// Row i = 0 ... along-1 runs from the first drawn end to the second, j = 0 ... across-1 from one
// selvage to the other. Particles are stored row by row. Both counts are at least 2.
struct RibbonGrid {
  int along = 0;
  int across = 0;

  [[nodiscard]] int particle(int i, int j) const { return i * across + j; }
  [[nodiscard]] int row(int particle) const { return particle / across; }
  [[nodiscard]] int column(int particle) const { return particle % across; }
  [[nodiscard]] int particle_count() const { return along * across; }
  [[nodiscard]] int quad_count() const { return (along - 1) * (across - 1); }
  [[nodiscard]] int triangle_count() const { return 2 * quad_count(); }

  // Corners of quad q (row by row), counter-clockwise about the ribbon's front:
  // (i,j), (i+1,j), (i+1,j+1), (i,j+1).
  [[nodiscard]] std::array<int, 4> quad(int q) const {
    const int corner = particle(q / (across - 1), q % (across - 1));
    return {corner, corner + across, corner + across + 1, corner + 1};
  }

  // 3 x triangle_count(): quad q is split into triangles 2q and 2q+1. The diagonal alternates from
  // quad to quad, so that cloth does not prefer one direction: it joins corners 0 and 2 where i+j
  // is even, 1 and 3 where it is odd.
  [[nodiscard]] Eigen::Matrix3Xi triangles() const {
    Eigen::Matrix3Xi result(3, triangle_count());
    for (int q = 0; q < quad_count(); ++q) {
      const auto c = quad(q);
      const Eigen::Index first = 2 * static_cast<Eigen::Index>(q);
      const bool even = (q / (across - 1) + q % (across - 1)) % 2 == 0;
      if (even) {
        result.col(first) << c[0], c[1], c[2];
        result.col(first + 1) << c[0], c[2], c[3];
      } else {
        result.col(first) << c[0], c[1], c[3];
        result.col(first + 1) << c[1], c[2], c[3];
      }
    }
    return result;
  }

  bool operator==(const RibbonGrid&) const = default;
};

}  // namespace ribbon
