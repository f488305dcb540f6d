#include "player/picture/color_map.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace ribbon {

namespace {

using Lab = Eigen::Array3f;

constexpr int fine_steps = 4096;  // along the path, to measure it
constexpr int map_steps = 256;

Lab as_array(const LabColor& lab) {
  return {lab.lightness, lab.green_red, lab.blue_yellow};
}

// Through the stations (Catmull-Rom); beyond the ends it goes straight on. Where lightness rises by
// the same amount from station to station it rises evenly between them, too.
Lab on_path(std::span<const LabColor> stations, float place) {
  const auto last = static_cast<int>(stations.size()) - 1;
  const int k = std::min(static_cast<int>(place * static_cast<float>(last)), last - 1);
  const float u = place * static_cast<float>(last) - static_cast<float>(k);
  const Lab b = as_array(stations[k]);
  const Lab c = as_array(stations[k + 1]);
  const Lab a = k > 0 ? as_array(stations[k - 1]) : 2 * b - c;
  const Lab d = k + 1 < last ? as_array(stations[k + 2]) : 2 * c - b;
  return (2 * b + (c - a) * u + (2 * a - 5 * b + 4 * c - d) * u * u +
          (3 * b - a - 3 * c + d) * u * u * u) /
         2;
}

float inverse_of_lab_curve(float value) {
  constexpr float border = 6.0F / 29;
  return value > border ? value * value * value : 3 * border * border * (value - 4.0F / 29);
}

constexpr std::array<LabColor, 5> blue_to_yellow = {
    {{25, 30, -48}, {42, 8, -42}, {58, -22, -20}, {75, -36, 20}, {93, -10, 56}}};
constexpr std::array<LabColor, 2> orange_to_pale = {{{52, 40, 54}, {88, 0, 2}}};
constexpr std::array<LabColor, 2> pale_to_blue = {{{88, 0, 2}, {52, -4, -42}}};

}  // namespace

Color linear_light(const LabColor& lab) {
  const float y = (lab.lightness + 16) / 116;
  const Eigen::Vector3f xyz(0.95047F * inverse_of_lab_curve(y + lab.green_red / 500),
                            inverse_of_lab_curve(y),
                            1.08883F * inverse_of_lab_curve(y - lab.blue_yellow / 200));
  Eigen::Matrix3f rgb_from_xyz;                          // IEC 61966-2-1
  rgb_from_xyz << 3.2404542F, -1.5371385F, -0.4985314F,  //
      -0.9692660F, 1.8760108F, 0.0415560F,               //
      0.0556434F, -0.2040259F, 1.0572252F;
  return (rgb_from_xyz * xyz).array();
}

ColorMap::ColorMap(std::span<const LabColor> stations) {
  assert(stations.size() >= 2);
  const auto fine = [&](int k) {
    return on_path(stations, static_cast<float>(k) / static_cast<float>(fine_steps));
  };
  std::vector<float> gone{0};  // along the path
  for (int k = 1; k <= fine_steps; ++k)
    gone.push_back(gone.back() + (fine(k) - fine(k - 1)).matrix().norm());
  for (int step = 0; step <= map_steps; ++step) {
    const float wanted = gone.back() * static_cast<float>(step) / map_steps;
    const auto there = std::lower_bound(gone.begin(), gone.end() - 1, wanted);
    const Lab lab = fine(static_cast<int>(there - gone.begin()));
    const Color color = linear_light({lab[0], lab[1], lab[2]});
    colors_.emplace_back(color.max(0.0F).min(1.0F));
  }
}

ColorMap::ColorMap(const ColorMap& first, const ColorMap& second) : colors_(first.colors_) {
  assert(first.colors_.size() == second.colors_.size());
  colors_.insert(colors_.end(), second.colors_.begin() + 1, second.colors_.end());
}

Color ColorMap::at(float place) const {
  const float on_map =
      place > 0 ? std::min(place, 1.0F) * static_cast<float>(colors_.size() - 1) : 0.0F;
  const auto step = std::min(static_cast<std::size_t>(on_map), colors_.size() - 2);
  return colors_[step] + (colors_[step + 1] - colors_[step]) * (on_map - static_cast<float>(step));
}

ColorMap ColorMap::reversed() const {
  ColorMap other = *this;
  std::reverse(other.colors_.begin(), other.colors_.end());
  return other;
}

const ColorMap& sequential_map() {
  static const ColorMap map(blue_to_yellow);
  return map;
}

const ColorMap& diverging_map() {
  static const ColorMap map{ColorMap(orange_to_pale), ColorMap(pale_to_blue)};
  return map;
}

}  // namespace ribbon
