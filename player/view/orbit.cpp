#include "player/view/orbit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ribbon {

namespace {

// Half the shorter side of a picture taken with View::lens_mm.
constexpr float half_film_mm = 12;

Eigen::Matrix3f world_from_camera(const View& view) {
  const float to_radians = std::numbers::pi_v<float> / 180.0F;
  const float azimuth = view.azimuth_deg * to_radians;
  const float elevation = view.elevation_deg * to_radians;
  const Eigen::Vector3f right(std::cos(azimuth), 0, -std::sin(azimuth));
  const Eigen::Vector3f backward(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                                 std::cos(azimuth) * std::cos(elevation));
  Eigen::Matrix3f axes;
  axes << right, backward.cross(right), backward;
  return axes;
}

}  // namespace

Camera camera_towards(const View& view, PictureSize size) {
  const auto shorter = static_cast<float>(std::min(size.width, size.height));
  const float half_view = half_film_mm / view.lens_mm;  // tangent of half the angle of view
  return {.world_from_camera = world_from_camera(view),
          .half_width = half_view * static_cast<float>(size.width) / shorter,
          .half_height = half_view * static_cast<float>(size.height) / shorter};
}

Camera orbit_camera(const View& view, PictureSize size, const Eigen::Vector3f& target,
                    float distance_m) {
  Camera camera = camera_towards(view, size);
  camera.eye = target + distance_m * camera.world_from_camera.col(2);
  return camera;
}

float distance_to_hold(float radius_m, const View& view, PictureSize size) {
  const Camera camera = camera_towards(view, size);
  const float half = std::min(camera.half_width, camera.half_height) * (1 - 2 * free_margin);
  return radius_m / std::sin(std::atan(half));
}

}  // namespace ribbon
