// What rays meet. Embree is behind this, and nowhere else.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>

#include "player/render/surface.h"

namespace ribbon {

struct Ray {
  Eigen::Vector3f origin;
  Eigen::Vector3f direction;
};

struct Hit {
  enum class Body : std::uint8_t { none, ribbon, obstacle };
  Body body = Body::none;
  std::uint32_t triangle = 0;
  float u = 0;  // weight of the triangle's second corner
  float v = 0;  // and of its third
};

// Rays that start near each other in similar directions are traced faster when this is said.
enum class Coherence { similar, mixed };

class RayScene {
 public:
  RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;
  ~RayScene();

  // The obstacle is built once, the ribbon anew for each frame; only one of each. The number of
  // the ribbon's vertices and triangles must not change.
  void set_obstacle(const Surface& obstacle);
  void set_ribbon(const Surface& ribbon);

  // Fills hits[i] with the first thing that rays[i] meets. Safe to call from several threads.
  void first_hits(std::span<const Ray> rays, Coherence coherence, std::span<Hit> hits) const;
  // Sets free[i] to 1 where rays[i] meets nothing, however far, and to 0 elsewhere.
  void unblocked(std::span<const Ray> rays, Coherence coherence,
                 std::span<std::uint8_t> free) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// While one lives, this thread's tiniest numbers count as zero, as Embree recommends; afterwards
// the thread is as it was before.
class FlushDenormals {
 public:
  FlushDenormals();
  ~FlushDenormals();
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned before_;
};

}  // namespace ribbon
