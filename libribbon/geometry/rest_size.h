// How large the flat band is, and how far apart its particles lie in it.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// A flat band whose middle line is straight: rows stand across it, evenly spaced, and the particles
// of a row are evenly spaced over its width.
struct RestSize {
  RibbonGrid grid;
  double length_m = 0;
  double width_m = 0;                     // the mean of all rows
  std::vector<double> row_widths_m = {};  // one a row; empty: each is width_m wide

  [[nodiscard]] bool has_profile() const { return !row_widths_m.empty(); }
  [[nodiscard]] double row_width_m(int row) const {
    return has_profile() ? row_widths_m[row] : width_m;
  }
  [[nodiscard]] double narrowest_m() const {
    return has_profile() ? *std::min_element(row_widths_m.begin(), row_widths_m.end()) : width_m;
  }
  [[nodiscard]] double widest_m() const {
    return has_profile() ? *std::max_element(row_widths_m.begin(), row_widths_m.end()) : width_m;
  }

  // From one row to the next, and from one particle of a row to the next: of a row of mean width,
  // of a certain one, and of the narrowest.
  [[nodiscard]] double along_m() const { return length_m / (grid.along - 1); }
  [[nodiscard]] double across_m() const { return width_m / (grid.across - 1); }
  [[nodiscard]] double across_m(int row) const { return row_width_m(row) / (grid.across - 1); }
  [[nodiscard]] double narrowest_across_m() const { return narrowest_m() / (grid.across - 1); }
  [[nodiscard]] double shortest_edge_m() const { return std::min(along_m(), narrowest_across_m()); }

  // How far a particle lies from the first row, and from the middle line.
  [[nodiscard]] Eigen::Vector2d place_m(int particle) const {
    const int row = grid.row(particle);
    return {row * along_m(), (grid.column(particle) - 0.5 * (grid.across - 1)) * across_m(row)};
  }

  // What these rows, the last included, weigh in rows of mean width.
  [[nodiscard]] double mean_rows(int first, int last) const {
    if (!has_profile()) return last - first + 1;
    double sum_m = 0;
    for (int row = first; row <= last; ++row) sum_m += row_widths_m[row];
    return sum_m / width_m;
  }

  // The same band, of a fraction of its width.
  [[nodiscard]] RestSize narrowed(double fraction) const {
    RestSize narrow{grid, length_m, fraction * width_m, row_widths_m};
    for (double& row_m : narrow.row_widths_m) row_m *= fraction;
    return narrow;
  }

  bool operator==(const RestSize&) const = default;
};

}  // namespace ribbon
