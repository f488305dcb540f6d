// Walking two trees, or one against itself, for the pairs that may meet.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "parallel/parallel.h"

namespace ribbon {

// Keeps its memory from one walk to the next.
template <class Found, class NodePair>
class BvhWalk {
 public:
  // Walks from `start` top-down: expand(pair, next, found) replaces a pair of nodes by those below
  // it that can still meet, and reports what it finds in pairs of leaves. The widest front is
  // shared out over the cores; the order of the answer, which the next walk overwrites, depends on
  // the trees alone.
  template <class Expand>
  const std::vector<Found>& from(const NodePair& start, const Expand& expand) {
    found_.clear();
    front_.assign(1, start);
    while (!front_.empty() && front_.size() < wide_enough) {
      next_.clear();
      for (const NodePair& pair : front_) expand(pair, next_, found_);
      front_.swap(next_);
    }
    const std::size_t parts = (front_.size() + grain - 1) / grain;
    parts_.resize(std::max(parts_.size(), parts));
    parallel_ranges(front_.size(), grain, [&](std::size_t begin, std::size_t end) {
      Part& part = parts_[begin / grain];
      part.found.clear();
      for (std::size_t i = begin; i < end; ++i) {
        part.open.assign(1, front_[i]);
        while (!part.open.empty()) {
          const NodePair pair = part.open.back();
          part.open.pop_back();
          expand(pair, part.open, part.found);
        }
      }
    });
    for (std::size_t part = 0; part < parts; ++part)
      found_.insert(found_.end(), parts_[part].found.begin(), parts_[part].found.end());
    return found_;
  }

 private:
  static constexpr std::size_t wide_enough = 512;
  static constexpr std::size_t grain = 16;
  struct Part {  // of the front
    std::vector<NodePair> open;
    std::vector<Found> found;
  };

  std::vector<Found> found_;
  std::vector<NodePair> front_;
  std::vector<NodePair> next_;
  std::vector<Part> parts_;
};

}  // namespace ribbon
