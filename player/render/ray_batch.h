// Rays and what they meet, side by side for vector instructions.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

namespace ribbon {

struct Ray {
  Eigen::Vector3f origin;
  Eigen::Vector3f direction;
};

inline constexpr std::size_t batch_size = 256;

// Loops over lanes go on to the end of the last vector register, as lanes that are left over would
// be gone through one by one. What stands there means nothing.
inline constexpr std::size_t register_lanes = 16;
constexpr std::size_t filled_up(std::size_t count) {
  return (count + register_lanes - 1) / register_lanes * register_lanes;
}

// With room to fill up a register from any lane on.
template <class Value>
using Lanes = std::array<Value, batch_size + register_lanes>;

// One vector a lane.
struct alignas(64) VectorLanes {
  Lanes<float> x;
  Lanes<float> y;
  Lanes<float> z;

  [[nodiscard]] Eigen::Vector3f at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
  void set(std::size_t lane, const Eigen::Vector3f& vector) {
    x[lane] = vector.x();
    y[lane] = vector.y();
    z[lane] = vector.z();
  }
};

struct RayBatch {
  VectorLanes origin;
  VectorLanes direction;
  // How wide what each of them looks at is, per length of its direction: pattern finer than that is
  // seen as its mean.
  float spread = 0;
  std::size_t count = 0;

  void add(const Ray& ray) {
    origin.set(count, ray.origin);
    direction.set(count++, ray.direction);
  }
  [[nodiscard]] Ray ray(std::size_t lane) const { return {origin.at(lane), direction.at(lane)}; }
};

enum class Body : std::uint8_t { none, ribbon, obstacle, ground };

// The first thing that each ray meets; where that is nothing body and distance are all that counts.
struct alignas(64) HitBatch {
  Lanes<std::uint32_t> triangle;
  Lanes<float> u;         // weight of the triangle's second corner
  Lanes<float> v;         // and of its third
  Lanes<float> distance;  // in lengths of the ray's direction; infinite where nothing is met
  Lanes<Body> body;
};

// Some of the lanes, in any order.
struct LaneList {
  Lanes<std::uint16_t> lanes;
  std::size_t count = 0;

  // Adds a lane if it is wanted: cheaper than to choose between two ways to go on.
  void add_if(std::size_t lane, bool wanted) {
    lanes[count] = static_cast<std::uint16_t>(lane);
    count += wanted ? 1 : 0;
  }
};

// Lanes that a mark chooses, ascending.
struct MarkedLanes : LaneList {
  // Of each register's lanes, the first of them the lowest bit.
  std::array<std::uint16_t, batch_size / register_lanes> masks;
};

// Those of the first `count` lanes, at most batch_size, that have this mark. `marks`: batch_size +
// register_lanes of them.
void list_marked(const std::uint8_t* marks, std::uint8_t mark, std::size_t count,
                 MarkedLanes& list);
inline void list_marked(const Lanes<Body>& bodies, Body body, std::size_t count,
                        MarkedLanes& list) {
  list_marked(reinterpret_cast<const std::uint8_t*>(bodies.data()), static_cast<std::uint8_t>(body),
              count, list);
}

// Numbers of the marked lanes, side by side; behind them a register's lanes may change.
void move_together(const Lanes<float>& numbers, const MarkedLanes& marked, float* to);
void move_together(const Lanes<std::uint32_t>& numbers, const MarkedLanes& marked,
                   std::uint32_t* to);
inline void move_together(const VectorLanes& vectors, const MarkedLanes& marked, VectorLanes& to) {
  move_together(vectors.x, marked, to.x.data());
  move_together(vectors.y, marked, to.y.data());
  move_together(vectors.z, marked, to.z.data());
}
// And back: numbers that lie side by side go to the marked lanes, 0 to the others up to the last.
void move_apart(const Lanes<float>& numbers, const MarkedLanes& marked, Lanes<float>& to);

}  // namespace ribbon
