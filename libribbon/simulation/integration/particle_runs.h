// Loops over particles that compute each by itself.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "parallel/parallel.h"

namespace ribbon {

// Calls body(first, count) for runs of consecutive particles, side by side on all cores. What a run
// reads and writes of a few arrays fits the fast memory of a core, so that what is done to it one
// after the other passes through slow memory once.
template <class Body>
void for_each_particle_run(Eigen::Index particles, const Body& body) {
  constexpr std::size_t particles_in_run = 1024;
  parallel_ranges(static_cast<std::size_t>(particles), particles_in_run,
                  [&](std::size_t begin, std::size_t end) {
                    body(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin));
                  });
}

}  // namespace ribbon
