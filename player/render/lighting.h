// The light that the scene stands in.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "player/picture/color.h"
#include "player/render/environment.h"

namespace ribbon {

struct Lighting {
  // Towards the sun, unit length; y is up, the knot lies at +z.
  Eigen::Vector3f sun_direction = Eigen::Vector3f(-0.45F, 0.72F, 0.53F).normalized();
  // Radiance of a white matte surface that faces the sun.
  Color sun = {0.80F, 0.76F, 0.68F};
  // Tangent of half the angle under which the sun is seen: larger makes softer shadows.
  float sun_radius = 0.05F;
  // Radiance of the sky straight above and straight below; it changes evenly in between.
  Color sky_above = {0.55F, 0.59F, 0.66F};
  Color sky_below = {0.21F, 0.20F, 0.19F};
  // What hides the sky in a fold is itself lit: the fraction of the sky's light that it returns.
  float bounce = 0.22F;

  // Takes the place of the even sky.
  std::shared_ptr<const Environment> environment = nullptr;

  [[nodiscard]] Color sky(const Eigen::Vector3f& direction) const {
    if (environment) return environment->sky(direction);
    return sky_below + (sky_above - sky_below) * (0.5F + direction.y() / 2);
  }
  // Mean over the directions about a unit normal, weighted by their cosine: what a white matte
  // surface shows under the open sky.
  [[nodiscard]] Color mean_sky(const Eigen::Vector3f& normal) const {
    if (environment) return environment->mean_sky(normal);
    return sky_below + (sky_above - sky_below) * (0.5F + normal.y() / 3);
  }
};

// Behind everything; it does not light the scene.
struct Backdrop {
  // From the top to the bottom of the picture.
  Color top = from_srgb(0xDDE2E8);
  Color bottom = from_srgb(0xF7F5F1);
  // Takes the place of these: what lies in each direction.
  std::shared_ptr<const Environment> environment = nullptr;

  // Of the colours: in row `y` of a picture `height` rows high.
  [[nodiscard]] Color at(int y, int height) const {
    const float down = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
    return top + (bottom - top) * down;
  }
};

}  // namespace ribbon
