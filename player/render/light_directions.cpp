#include "player/render/light_directions.h"

#include <cmath>

#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

// Two directions that complete `axis` to a right-handed frame (T. Duff and others, Building an
// Orthonormal Basis, Revisited, JCGT 6(1), 2017).
struct Frame {
  float first_x, first_y, first_z;
  float second_x, second_y, second_z;

  [[gnu::always_inline]] Frame(float x, float y, float z) {
    const float sign = z < 0 ? -1.0F : 1.0F;
    const float a = -1 / (sign + z);
    const float b = x * y * a;
    first_x = 1 + sign * x * x * a;
    first_y = sign * b;
    first_z = -sign * x;
    second_x = b;
    second_y = sign + y * y * a;
    second_z = -y;
  }
};

}  // namespace

void to_disc(const Lanes<float>& u, const Lanes<float>& v, std::size_t count, Lanes<float>& x,
             Lanes<float>& y) {
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      const float radius = std::sqrt(u[i]);
      // Half the angle, -pi/2 to pi/2, by the first terms of the series: within 2e-4.
      const float half = 3.14159265F * (v[i] - 0.5F);
      const float square = half * half;
      const float sine =
          half * (1 + square * (-0.16666667F + square * (0.00833333F - square * 0.00019841F)));
      const float cosine =
          1 +
          square * (-0.5F + square * (0.04166667F + square * (-0.00138889F + square * 2.48e-5F)));
      x[i] = radius * (cosine * cosine - sine * sine);
      y[i] = radius * 2 * sine * cosine;
    }
  });
}

void to_sun(const Eigen::Vector3f& middle, float radius, const Lanes<float>& disc_x,
            const Lanes<float>& disc_y, std::size_t count, VectorLanes& direction) {
  const Frame frame(middle.x(), middle.y(), middle.z());
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      const float x = radius * disc_x[i];
      const float y = radius * disc_y[i];
      const float inverse = 1 / std::sqrt(1 + x * x + y * y);
      direction.x[i] = (middle.x() + x * frame.first_x + y * frame.second_x) * inverse;
      direction.y[i] = (middle.y() + x * frame.first_y + y * frame.second_y) * inverse;
      direction.z[i] = (middle.z() + x * frame.first_z + y * frame.second_z) * inverse;
    }
  });
}

void to_sky(const VectorLanes& normal, const Lanes<float>& disc_x, const Lanes<float>& disc_y,
            std::size_t count, VectorLanes& direction) {
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i) {
      const Frame frame(normal.x[i], normal.y[i], normal.z[i]);
      const float x = disc_x[i];
      const float y = disc_y[i];
      const float squared = 1 - x * x - y * y;
      const float height = std::sqrt(squared < 0 ? 0.0F : squared);
      direction.x[i] = x * frame.first_x + y * frame.second_x + height * normal.x[i];
      direction.y[i] = x * frame.first_y + y * frame.second_y + height * normal.y[i];
      direction.z[i] = x * frame.first_z + y * frame.second_z + height * normal.z[i];
    }
  });
}

void products(const VectorLanes& a, const VectorLanes& b, std::size_t count, Lanes<float>& result) {
  vectorised([&]() RIBBON_INLINED {
    const std::size_t end = filled_up(count);
    RIBBON_EACH_LANE
    for (std::size_t i = 0; i < end; ++i)
      result[i] = a.x[i] * b.x[i] + a.y[i] * b.y[i] + a.z[i] * b.z[i];
  });
}

}  // namespace ribbon
