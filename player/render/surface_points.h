// Points on surfaces as light needs them, side by side for vector instructions.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "player/render/ray_batch.h"
#include "player/render/surface.h"

namespace ribbon {

struct SurfaceBatch {
  VectorLanes position;
  VectorLanes start;   // from where rays towards the light go
  VectorLanes normal;  // of the smooth surface that the triangles stand for, unit length, to the
                       // side that is looked at
  VectorLanes albedo;  // fraction of the light that it returns: red, green, blue
  Lanes<Body> body;
  std::size_t count = 0;
};

// What the pattern of a surface shows there. Lengths are in units of the texture.
struct LookBatch {
  Lanes<float> x;  // of the texture
  Lanes<float> y;
  Lanes<float> front;  // 1 where it is the front that is seen, otherwise 0
  Lanes<float> reach;  // how wide the look is
};

// Surfaces as rays meet them: all of a corner lies together. What a triangle's corners tell is
// worked out where it is met, so that little memory is gone through.
class HitSurface {
 public:
  struct alignas(32) Corner {
    // Three of its position, three of its normal, two of its place in the texture.
    std::array<float, 8> numbers;

    [[nodiscard]] float* position() { return numbers.data(); }
    [[nodiscard]] float* normal() { return numbers.data() + 3; }
    void set_texture(float x, float y) {
      numbers[6] = x;
      numbers[7] = y;
    }
  };
  using Corners = std::array<int, 3>;  // of a triangle

  HitSurface() = default;
  // The unit is one of the texture's.
  explicit HitSurface(const Surface& surface, float unit_m = 1);

  // Takes over positions and normals, which are those of the first vertices.
  void move_to(const Surface& surface);
  [[nodiscard]] std::vector<Corner>& corners() { return corners_; }
  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }
  [[nodiscard]] const std::vector<Corners>& triangles() const { return triangles_; }

  // Fills those of `batch` from batch.count on, but for body and albedo, with what the listed rays
  // met, and `looks` from 0 on. clearance_m: by which light starts above a facet.
  void find_points(const RayBatch& rays, const HitBatch& hits, const MarkedLanes& list,
                   float clearance_m, SurfaceBatch& batch, LookBatch& looks) const;

 private:
  float unit_m_ = 1;
  std::vector<Corner> corners_;
  std::vector<Corners> triangles_;
};

}  // namespace ribbon
