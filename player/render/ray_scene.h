// What rays meet. Embree is behind this, and nowhere else.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "player/render/ray_batch.h"
#include "player/render/ray_log.h"
#include "player/render/ribbon_tree.h"
#include "player/render/surface_points.h"

namespace ribbon {

// What the results of rays depend on, to the last bit: the library, its version and the vector
// instructions that it is told to use ("Embree 3.13.5 with avx2"): those of instruction_set().
std::string ray_tracer_name();

// Rays that start near each other in similar directions are traced faster when this is said.
enum class Coherence { similar, mixed };

class RayScene {
 public:
  RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;
  ~RayScene();

  // The ribbon's triangles, and behind them the obstacle's: always the same, the ribbon moved, with
  // a tree that is rebuilt the first time. They are not copied and must stay where they are as long
  // as the scene.
  void set_bodies(const HitSurface& bodies, std::uint32_t ribbon_triangles, RibbonTree tree);

  // Fills lane i of `hits` with the first thing that ray i meets. Safe to call from several
  // threads.
  void first_hits(const RayBatch& rays, Coherence coherence, HitBatch& hits) const;
  // Sets free[i] to 1 where ray i meets nothing, however far, and to 0 elsewhere.
  void unblocked(const RayBatch& rays, Coherence coherence, Lanes<float>& free) const;

  // From now on all rays are logged, until `log` is null. For measurements.
  void log_to(RayLog* log) { log_ = log; }
  // How long Embree itself takes for these rays: packets are filled and answers left lying outside
  // of the time. Seconds of all threads together.
  [[nodiscard]] double plain_seconds(const RayLog& log) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
  RayLog* log_ = nullptr;
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
