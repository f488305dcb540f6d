// The width of a band that is not as wide everywhere.
#pragma once

#include <string>
#include <vector>

namespace ribbon {

struct RibbonScene;

struct WidthAt {
  double share = 0;  // of the length, from the first drawn end
  double width_m = 0;

  bool operator==(const WidthAt&) const = default;
};

struct WidthProfile {
  std::vector<WidthAt> points;  // at least 2, their shares rising from 0 to 1; widths above 0
  std::string place = {};       // where the scene says it: "knot.toml:12:8"; empty: nowhere

  // Wherever it stands.
  bool operator==(const WidthProfile& other) const { return points == other.points; }
};

// At a share (0 to 1) of the length. Between the points runs a cubic that rises and falls only
// where they do (Fritsch and Butland, "A method for constructing local monotone piecewise cubic
// interpolants", 1984).
double width_at_m(const WidthProfile& profile, double share);
double width_at_m(const RibbonScene& ribbon, double share);

// Of each of the evenly spaced rows, rounded to single precision, as recordings keep them. Empty
// where all are as wide.
std::vector<double> row_widths_m(const RibbonScene& ribbon);

// Of its widest row.
double widest_m(const RibbonScene& ribbon);

// Of all rows.
double mean_width_m(const RibbonScene& ribbon);

}  // namespace ribbon
