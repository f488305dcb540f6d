// Loops over particles that compute each by itself.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "parallel/parallel.h"

namespace ribbon {

inline constexpr std::size_t particles_in_run = 1024;

// Calls body(first, count) for runs of consecutive particles, side by side on all cores. What a run
// reads and writes of a few arrays fits the fast memory of a core, so that what is done to it one
// after the other passes through slow memory once.
template <class Body>
void for_each_particle_run(Eigen::Index particles, const Body& body) {
  parallel_ranges(static_cast<std::size_t>(particles), particles_in_run,
                  [&](std::size_t begin, std::size_t end) {
                    body(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin));
                  });
}

// Sums over all particles, the runs in their order.
template <std::size_t count>
class RunSums {
 public:
  using Sums = std::array<double, count>;

  // Calls body(first, count, sums), where `sums` are those of the run, at first 0.
  template <class Body>
  [[nodiscard]] Sums of(Eigen::Index particles, const Body& body) {
    of_runs_.assign((static_cast<std::size_t>(particles) + particles_in_run - 1) / particles_in_run,
                    Sums{});
    for_each_particle_run(particles, [&](Eigen::Index first, Eigen::Index particle_count) {
      body(first, particle_count, of_runs_[static_cast<std::size_t>(first) / particles_in_run]);
    });
    Sums total{};
    for (const Sums& of_run : of_runs_)
      for (std::size_t i = 0; i < count; ++i) total[i] += of_run[i];
    return total;
  }

 private:
  std::vector<Sums> of_runs_;
};

}  // namespace ribbon
