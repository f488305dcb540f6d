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

  // Corners of the quad that begins at particle (i, j), counter-clockwise about the ribbon's front:
  // (i,j), (i+1,j), (i+1,j+1), (i,j+1). Quads are numbered row by row.
  [[nodiscard]] std::array<int, 4> quad(int i, int j) const {
    const int corner = particle(i, j);
    return {corner, corner + across, corner + across + 1, corner + 1};
  }
  [[nodiscard]] std::array<int, 4> quad(int q) const {
    return quad(q / (across - 1), q % (across - 1));
  }

  // The diagonal that splits quad q into triangles 2q and 2q+1, its smaller end first. It
  // alternates from quad to quad, so that cloth does not prefer one direction: it joins corners 0
  // and 2 where i+j is even, 3 and 1 where it is odd.
  [[nodiscard]] std::array<int, 2> diagonal(int i, int j) const {
    const auto c = quad(i, j);
    return (i + j) % 2 == 0 ? std::array{c[0], c[2]} : std::array{c[3], c[1]};
  }
  [[nodiscard]] std::array<int, 2> diagonal(int q) const {
    return diagonal(q / (across - 1), q % (across - 1));
  }

  // The corners of quad (i, j), beginning with one from which a fan (first, second, third; first,
  // third, fourth) splits it along its diagonal.
  [[nodiscard]] std::array<int, 4> fan(int i, int j) const {
    const auto c = quad(i, j);
    return (i + j) % 2 == 0 ? c : std::array{c[1], c[2], c[3], c[0]};
  }
  [[nodiscard]] std::array<int, 4> fan(int q) const {
    return fan(q / (across - 1), q % (across - 1));
  }

  // Corners of the two triangles of a quad, and of triangle t.
  [[nodiscard]] std::array<std::array<int, 3>, 2> halves(int i, int j) const {
    const auto c = quad(i, j);
    if ((i + j) % 2 == 0) return {{{c[0], c[1], c[2]}, {c[0], c[2], c[3]}}};
    return {{{c[0], c[1], c[3]}, {c[1], c[2], c[3]}}};
  }
  [[nodiscard]] std::array<int, 3> triangle(int t) const {
    const int q = t / 2;
    return halves(q / (across - 1), q % (across - 1))[t % 2];
  }

  // Asks is_found(b, c) of the triangles that have this particle, with their two other corners,
  // until one says yes. Did one?
  template <class IsFound>
  [[nodiscard]] bool any_triangle_at(int particle, const IsFound& is_found) const {
    // Diagonals meet where i+j is even; between them, a neighbour along and one across make a
    // triangle.
    constexpr std::array<std::array<int, 2>, 8> round = {
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    const int i = row(particle);
    const int j = column(particle);
    const auto is_inside = [&](const std::array<int, 2>& offset) {
      const int at_i = i + offset[0];
      const int at_j = j + offset[1];
      return at_i >= 0 && at_i < along && at_j >= 0 && at_j < across;
    };
    const unsigned step = (i + j) % 2 == 0 ? 1 : 2;
    for (unsigned k = 0; k < round.size(); k += step) {
      const std::array<int, 2>& b = round[k];
      const std::array<int, 2>& c = round[(k + step) % round.size()];
      if (is_inside(b) && is_inside(c) &&
          is_found(particle + b[0] * across + b[1], particle + c[0] * across + c[1]))
        return true;
    }
    return false;
  }

  // 3 x triangle_count().
  [[nodiscard]] Eigen::Matrix3Xi triangles() const {
    Eigen::Matrix3Xi result(3, triangle_count());
    for (int t = 0; t < triangle_count(); ++t) {
      const auto corners = triangle(t);
      result.col(t) << corners[0], corners[1], corners[2];
    }
    return result;
  }

  bool operator==(const RibbonGrid&) const = default;
};

}  // namespace ribbon
