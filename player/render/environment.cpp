#include "player/render/environment.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/angles.h"

namespace ribbon {

namespace {

constexpr double pi = std::numbers::pi;
constexpr float width_of_look = std::numbers::pi_v<float> / 32;
constexpr int map_rows = 64;  // directions that are summed up, twice as many columns

Eigen::Vector3f direction_at(int column, int row) {
  const double round = (column + 0.5) / (2 * map_rows) * 2 * pi - pi;
  const double down = (row + 0.5) / map_rows * pi;
  return {static_cast<float>(sine(down) * sine(round)), static_cast<float>(cosine(down)),
          static_cast<float>(sine(down) * cosine(round))};
}

}  // namespace

Environment::Environment(Texture panorama) : panorama_(std::move(panorama)) {
  // What a matte surface makes of each band of harmonics, over pi.
  constexpr std::array<float, harmonics> of_band{1,     2.0F / 3, 2.0F / 3, 2.0F / 3, 0.25F,
                                                 0.25F, 0.25F,    0.25F,    0.25F};
  means_.fill(Color::Zero());
  for (int row = 0; row < map_rows; ++row) {
    const double solid_angle =
        2 * pi / (2 * map_rows) * pi / map_rows * sine((row + 0.5) / map_rows * pi);
    for (int column = 0; column < 2 * map_rows; ++column) {
      const Eigen::Vector3f direction = direction_at(column, row);
      const auto values = harmonics_at(direction);
      const Color light = sky(direction) * static_cast<float>(solid_angle);
      for (std::size_t h = 0; h < harmonics; ++h) means_[h] += light * (values[h] * of_band[h]);
    }
  }
}

Color Environment::sky(const Eigen::Vector3f& direction) const {
  return seen(direction, width_of_look);
}

Color Environment::seen(const Eigen::Vector3f& direction, float angle) const {
  const double level = std::sqrt(direction.x() * direction.x() + direction.z() * direction.z());
  const double round = polar_angle(direction.z(), direction.x());
  const double up = polar_angle(level, direction.y());
  return panorama_.at(static_cast<float>(round / (2 * pi) + 0.5), static_cast<float>(up / pi + 0.5),
                      angle / std::numbers::pi_v<float>);
}

std::array<float, Environment::harmonics> Environment::harmonics_at(
    const Eigen::Vector3f& direction) {
  const float x = direction.x();
  const float y = direction.y();
  const float z = direction.z();
  return {0.282095F,
          0.488603F * y,
          0.488603F * z,
          0.488603F * x,
          1.092548F * x * y,
          1.092548F * y * z,
          0.315392F * (3 * z * z - 1),
          1.092548F * x * z,
          0.546274F * (x * x - y * y)};
}

Color Environment::mean_sky(const Eigen::Vector3f& normal) const {
  const auto values = harmonics_at(normal);
  Color light = Color::Zero();
  for (std::size_t h = 0; h < harmonics; ++h) light += means_[h] * values[h];
  return light.max(0.0F);
}

}  // namespace ribbon
