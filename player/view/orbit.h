// A camera that looks at a point from somewhere around it.
#pragma once

#include <Eigen/Core>

#include "player/picture/picture.h"
#include "player/view/camera.h"
#include "player/view/view.h"

namespace ribbon {

// Of the picture, kept free on each side.
inline constexpr float free_margin = 0.04F;

// The direction and the lens of `view`; the eye at the origin.
Camera camera_towards(const View& view, PictureSize size);

// The eye `distance_m` from `target`.
Camera orbit_camera(const View& view, PictureSize size, const Eigen::Vector3f& target,
                    float distance_m);

// How far away a sphere just fits the picture.
float distance_to_hold(float radius_m, const View& view, PictureSize size);

}  // namespace ribbon
