// Light from all around, as a picture tells it.
#pragma once

#include <Eigen/Core>
#include <array>

#include "player/picture/color.h"
#include "player/picture/texture.h"

namespace ribbon {

// The picture is a map of all directions as panoramas have it: from left to right once round the
// upright axis, its middle what lies at +z, from top to bottom from straight up to straight down.
class Environment {
 public:
  explicit Environment(Texture panorama);

  // That it takes in memory.
  [[nodiscard]] std::size_t bytes() const { return panorama_.bytes(); }
  // Radiance from a direction of unit length, of a part that is `angle` wide (radians).
  [[nodiscard]] Color seen(const Eigen::Vector3f& direction, float angle) const;
  // Likewise, of a part of the sky some degrees wide: finer detail would only be noise in the light
  // of cloth.
  [[nodiscard]] Color sky(const Eigen::Vector3f& direction) const;
  // Mean over the directions about a unit normal, weighted by their cosine (R. Ramamoorthi and P.
  // Hanrahan, An Efficient Representation for Irradiance Environment Maps, SIGGRAPH 2001: within a
  // few percent).
  [[nodiscard]] Color mean_sky(const Eigen::Vector3f& normal) const;

 private:
  static constexpr int harmonics = 9;
  static std::array<float, harmonics> harmonics_at(const Eigen::Vector3f& direction);

  Texture panorama_;
  std::array<Color, harmonics> means_;
};

}  // namespace ribbon
