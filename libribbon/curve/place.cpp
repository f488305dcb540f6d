#include "curve/place.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text/number_text.h"

namespace ribbon {

namespace {

// The value to that many digits, the first of which is the first of `scale` (> 0).
std::string rounded(double value, double scale, int digits) {
  const double unit = std::pow(10, std::floor(std::log10(scale)) - (digits - 1));
  return short_number(std::round(value / unit) * unit + 0.0, digits + 1);  // no -0
}

}  // namespace

std::string three_digits(double value) {
  return rounded(value, value, 3);
}

std::string coordinates(const Eigen::Vector2d& point) {
  const double scale = std::max(point.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
  std::string text = "(";
  text += rounded(point.x(), scale, 5);
  text += ", ";
  text += rounded(point.y(), scale, 5);
  text += ")";
  return text;
}

std::string drawing_place(const Eigen::Vector2d& point) {
  std::string text = "drawing at ";
  text += coordinates(point);
  return text;
}

}  // namespace ribbon
