// Fastening in stages, as a scene asks for it: knots fastened one by one (paper, section 7).
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ribbon {

// A part of the band, as shares of its length: 0 is the end where its path begins.
struct Span {
  double begin = 0;
  double end = 0;  // not below begin

  bool operator==(const Span&) const = default;
};

// A circle of the drawing: the hand holds the band where its path comes nearest, as much of it as
// it is wide.
struct Mark {
  std::string id;
  std::string place = {};  // where the scene names it: "knot.toml:12:8"; empty: nowhere

  // Wherever it stands.
  bool operator==(const Mark& other) const { return id == other.id; }
};

// From one place of the band to another, each a share of its length or a mark, in either order.
struct BandPart {
  std::array<std::variant<double, Mark>, 2> ends;

  bool operator==(const BandPart&) const = default;
};

// The yield_strain of hands that never give way.
inline constexpr double unyielding = std::numeric_limits<double>::infinity();

// What a hand does with its part of the band: pulls it in one direction, along the band with the
// fastening force, or away from the axis; holds it where it is when the stage begins; or carries it
// from there along a path.
enum class HandTask { pull, pull_along, pull_outwards, hold, carry };

constexpr bool pulls(HandTask task) {
  return task != HandTask::hold && task != HandTask::carry;
}

// A path of the drawing, other than the band's.
struct PathId {
  std::string id;
  std::string place = {};  // as that of a Mark

  // Wherever it stands.
  bool operator==(const PathId& other) const { return id == other.id; }
};

struct HeightAt {
  double share = 0;     // of the path's length
  double height_m = 0;  // above the plane of the drawing, along its axis

  bool operator==(const HeightAt&) const = default;
};

// Where a hand carries its part: seen along the drawing's axis on a path, in its plane or above it.
struct CarryPath {
  // Points: at least 2, in drawing units, y down as in SVG.
  std::variant<PathId, std::vector<Eigen::Vector2d>> path;
  // Their shares rise; straight between them. At least one, which counts everywhere if it is alone.
  std::vector<HeightAt> heights = {HeightAt{}};

  bool operator==(const CarryPath&) const = default;
};

struct HandScene {
  std::variant<Span, Mark> at;
  std::optional<HandTask> task = std::nullopt;  // in a scene that has been read there is one
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // of HandTask::pull, of unit length
  double speed_m_s = 0;  // at which it would draw half of the band if nothing held that; along: as
                         // FasteningScene::speed_m_s. Its force is never more. Carrying, it goes
                         // along its path as fast.
  std::optional<double> yield_strain =
      std::nullopt;      // at which a hand that pulls gives way; none: never, but in a file that
                         // leaves it out as FasteningScene::yield_strain
  CarryPath carry = {};  // of HandTask::carry

  bool operator==(const HandScene&) const = default;
};

// What ends a stage that has no time: all that is pulled has come to a stop and all that is carried
// has arrived, or only the latter.
enum class StageGoal { tight, carried };

struct StageScene {
  std::string name = {};
  std::optional<double> until_s = std::nullopt;    // how long it lasts; none: until its goal
  std::optional<double> at_most_s = std::nullopt;  // how long that may take; none: any time
  std::optional<double> friction = std::nullopt;   // until the next; none: the scene's
  std::optional<Eigen::Vector3d> gravity_m_s2 = std::nullopt;  // likewise; zero: there is none
  std::vector<HandScene> hands;                                // at least one
  StageGoal goal = StageGoal::tight;

  bool operator==(const StageScene&) const = default;
};

// A recording numbers them by one byte.
inline constexpr int most_stages = 200;

}  // namespace ribbon
