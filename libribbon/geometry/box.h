// Axis-aligned boxes.
#pragma once

#include <Eigen/Core>
#include <cstring>
#include <limits>

namespace ribbon {

#ifdef RIBBON_COUNT_BOX_TESTS
// Told of each test of a box against another, in programs that count them.
void count_box_test();
#else
constexpr void count_box_test() {}
#endif

struct Box {
  Eigen::Vector3d low;
  Eigen::Vector3d high;

  static Box around(const Eigen::Vector3d& point) { return {point, point}; }
  void include(const Eigen::Vector3d& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  void include(const Box& box) {
    low = low.cwiseMin(box.low);
    high = high.cwiseMax(box.high);
  }
  void grow(double margin) {
    low.array() -= margin;
    high.array() += margin;
  }
  [[nodiscard]] bool contains(const Eigen::Vector3d& point) const {
    return (low.array() <= point.array()).all() && (point.array() <= high.array()).all();
  }
  [[nodiscard]] bool meets(const Box& box) const {
    count_box_test();
    return low[0] <= box.high[0] && box.low[0] <= high[0] && low[1] <= box.high[1] &&
           box.low[1] <= high[1] && low[2] <= box.high[2] && box.low[2] <= high[2];
  }
};

// What encloses points that move along straight ways, all from their starts to their ends in the
// same time: at every instant they lie inside the box between `start` and `end` in proportion, for
// the lowest of linear functions never falls under its chord.
struct MovingBox {
  Box start;
  Box end;

  void include(const MovingBox& box) {
    start.include(box.start);
    end.include(box.end);
  }
  void grow(double margin) {
    start.grow(margin);
    end.grow(margin);
  }
  // Can the two touch at some instant? Not if they lie apart in one coordinate, in the same order,
  // at the start and at the end.
  [[nodiscard]] bool meets(const MovingBox& box) const {
    count_box_test();
    for (int k = 0; k < 3; ++k)
      if ((start.high[k] < box.start.low[k] && end.high[k] < box.end.low[k]) ||
          (box.start.high[k] < start.low[k] && box.end.high[k] < end.low[k]))
        return false;
    return true;
  }
};

// A MovingBox rounded outwards to single precision, for fast tests of many.
struct PackedBox {
  using Lanes = Eigen::Array4f;  // x, y, z and 0

  Lanes start_low;
  Lanes start_high;
  Lanes end_low;
  Lanes end_high;

  // Grown by a margin. Single precision is finest near the origin, so boxes that are tested against
  // each other are all packed about one that is near them (in double precision, the same for all).
  static PackedBox around(const MovingBox& box, double margin, const Eigen::Vector3d& origin) {
    return {rounded(box.start.low, -margin, origin, -1), rounded(box.start.high, margin, origin, 1),
            rounded(box.end.low, -margin, origin, -1), rounded(box.end.high, margin, origin, 1)};
  }
  // Likewise, of a box that stays where it is.
  static PackedBox around(const Box& still, double margin, const Eigen::Vector3d& origin) {
    const Lanes low = rounded(still.low, -margin, origin, -1);
    const Lanes high = rounded(still.high, margin, origin, 1);
    return {low, high, low, high};
  }
  void include(const PackedBox& box) {
    start_low = start_low.min(box.start_low);
    start_high = start_high.max(box.start_high);
    end_low = end_low.min(box.end_low);
    end_high = end_high.max(box.end_high);
  }
  // As for moving boxes.
  [[nodiscard]] bool meets(const PackedBox& box) const {
    count_box_test();
    const Lanes above = (start_low - box.start_high).min(end_low - box.end_high);
    const Lanes below = (box.start_low - start_high).min(box.end_low - end_high);
    return !(above.max(below).maxCoeff() > 0);
  }

 private:
  using Doubles [[gnu::vector_size(4 * sizeof(double))]] = double;
  using Floats [[gnu::vector_size(4 * sizeof(float))]] = float;

  // Farther out by more than the conversion and the origin's subtraction can be wrong.
  static Lanes rounded(const Eigen::Vector3d& bound, double margin, const Eigen::Vector3d& origin,
                       float outwards) {
    const auto lane = [&](int k) { return bound[k] + margin - origin[k]; };
    const Doubles exact{lane(0), lane(1), lane(2), 0};
    const Floats single = __builtin_convertvector(exact, Floats);
    Lanes lanes;
    std::memcpy(lanes.data(), &single, sizeof(single));
    return lanes + 2 * outwards * std::numeric_limits<float>::epsilon() * lanes.abs();
  }
};

}  // namespace ribbon
