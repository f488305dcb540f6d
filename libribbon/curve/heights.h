// How high each passage of the walk runs, so that bands have room where they cross and none rises
// too steeply between.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace ribbon {

// A passage in front of the object runs at least half a gap above a height, one behind it at least
// as far below.
struct ObjectBound {
  std::size_t passage = 0;
  double height = 0;
  bool in_front = true;
};

// The walk as a chain of ways. Passages are counted from 0 to n - 1.
struct WalkProfile {
  // The most that each way may rise or fall: from the start to passage 0, from each passage to the
  // next, from passage n - 1 to the end. None below 0.
  std::vector<double> rises;
  struct Crossing {
    std::size_t above = 0;  // passage
    std::size_t below = 0;
    double share = 1;  // of the gap that is needed there: above 0, at most 1
  };
  std::vector<Crossing> crossings;
  std::vector<ObjectBound> bounds = {};  // where it passes the object

  [[nodiscard]] std::size_t passage_count() const { return rises.size() - 1; }
};

// A piece of the walk, from passage `from` - 1 to passage `to`, where the start counts as passage
// -1 and the end as passage n: the ways `from` to `to`.
struct Stretch {
  std::size_t from = 0;
  std::size_t to = 0;
};

// Why a profile has no room: round a circle of crossings, bounds and stretches of the walk, the
// crossings and the object take more height than the stretches can rise.
struct TightCircle {
  double crossings = 0;  // their shares together
  std::size_t bounds = 0;
  double object = 0;  // height that the bounds take besides their gaps
  std::vector<Stretch> stretches;
  double rise = 0;  // of all stretches together

  // The height that crossings and bounds take for each length of the gap.
  [[nodiscard]] double rise_per_gap() const {
    return crossings + 0.5 * static_cast<double>(bounds);
  }
  // The widest gap for which there is room; not above 0 where there is none for any.
  [[nodiscard]] double gap() const { return (rise - object) / rise_per_gap(); }
};

struct Heights {
  std::vector<double> passages;  // above the plane of both ends; none where no gap has room
  double gap = 0;                // what was asked for, or what there is room for
  std::optional<TightCircle> tight = std::nullopt;  // where there was no room for it
};

// Passages its share of `gap` apart at each crossing. If the ways allow it, half of that above and
// below the plane. Else each passage lies in the middle between the highest and the lowest place
// that difference constraints leave it (Bellman 1958); where they leave none, the gap is the widest
// for which they do, to a thousandth. With bounds, all stay as near to the plane as is possible.
Heights passage_heights(const WalkProfile& profile, double gap);

}  // namespace ribbon
