#include "curve/place.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace ribbon {

namespace {

// The value to that many digits, the first of which is the first of `scale` (> 0).
std::string rounded(double value, double scale, int digits) {
  const double unit = std::pow(10, std::floor(std::log10(scale)) - (digits - 1));
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(digits + 1) << std::round(value / unit) * unit + 0.0;  // no -0
  return text.str();
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
