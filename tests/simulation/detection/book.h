// Many triangles at one edge.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace ribbon {

// `pages` triangles at a common edge 0.2 m long, all round it. Their outer corners stand 1 m away
// at so many places: as many as there are pages, or fewer, so that some are copies of others.
struct Book {
  explicit Book(int pages, int outer_corners)
      : triangles(3, pages), vertices(3, 2 + outer_corners) {
    vertices.leftCols(2) << 0, 0, -0.1, 0.1, 0, 0;
    for (int corner = 0; corner < outer_corners; ++corner) {
      const double angle = 2 * std::numbers::pi * corner / outer_corners;
      vertices.col(2 + corner) << std::cos(angle), 0, std::sin(angle);
    }
    for (int page = 0; page < pages; ++page) triangles.col(page) << 0, 1, 2 + page % outer_corners;
  }

  Eigen::Matrix3Xi triangles;
  Eigen::Matrix3Xd vertices;
};

}  // namespace ribbon
