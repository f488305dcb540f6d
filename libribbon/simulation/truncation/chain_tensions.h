// A chain of bodies whose links may grow slack but not longer.
#pragma once

#include <span>
#include <vector>

namespace ribbon {

// Link i joins bodies i and i + 1 of a chain. Tensions pull the two together, each body by its
// weight times the tension, so that no link is longer than it may be and none is under tension that
// is slack: a linear complementarity problem with a tridiagonal matrix, which is solved directly,
// for those links that are under tension; which these are is found by the primal-dual active set
// method (Hintermüller, Ito and Kunisch, 2002). Keeps its memory.
class ChainTensions {
 public:
  // weights: of each body, above 0: 1 over its mass in any unit.
  explicit ChainTensions(std::vector<double> weights);

  // slack: by how much each link may still grow; below 0 where it is too long, infinite where
  // nothing joins the two bodies. cosines: of the angle between each link and the next; none is
  // asked for beside an infinite slack. At first links are taken to be under tension whose slack is
  // below `tight` (>= 0): of a chain that is drawn these are nearly all, and growing a set link by
  // link takes as many solutions. Returns a tension for each link, in the unit of `slack` over that
  // of the weights. After 30 solutions it may be short of the answer, but is always one by which
  // the links under tension come to be just as long as they may.
  std::span<const double> find(std::span<const double> slack, std::span<const double> cosines,
                               double tight);

 private:
  void solve(std::span<const double> slack, std::span<const double> cosines);
  bool revise(std::span<const double> slack, std::span<const double> cosines);

  std::vector<double> weights_;
  std::vector<double> tensions_;
  std::vector<double> eliminated_;
  std::vector<char> is_tense_;
  std::vector<char> was_tense_;
};

}  // namespace ribbon
