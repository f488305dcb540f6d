// Walking two trees, or one against itself, for the pairs that may meet.
#pragma once

#include <cstddef>
#include <vector>

#include "parallel/parallel.h"

namespace ribbon {

// Walks from `start` top-down: expand(pair, next, found) replaces a pair of nodes by those below it
// that can still meet, and reports what it finds in pairs of leaves. The widest front is shared out
// over the cores; the order of the answer depends on the trees alone.
template <class Found, class NodePair, class Expand>
std::vector<Found> walk(const NodePair& start, const Expand& expand) {
  constexpr std::size_t wide_enough = 512;
  std::vector<Found> found;
  std::vector<NodePair> front{start};
  std::vector<NodePair> next;
  while (!front.empty() && front.size() < wide_enough) {
    next.clear();
    for (const NodePair& pair : front) expand(pair, next, found);
    front.swap(next);
  }
  std::vector<std::vector<Found>> found_below(front.size());
  parallel_ranges(front.size(), 16, [&](std::size_t begin, std::size_t end) {
    std::vector<NodePair> open;
    for (std::size_t i = begin; i < end; ++i) {
      open.assign(1, front[i]);
      while (!open.empty()) {
        const NodePair pair = open.back();
        open.pop_back();
        expand(pair, open, found_below[i]);
      }
    }
  });
  for (const auto& below : found_below) found.insert(found.end(), below.begin(), below.end());
  return found;
}

}  // namespace ribbon
