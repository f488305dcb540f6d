// How a run came out: is the ribbon tied round its object, or did it slip off?
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "geometry/object_axis.h"
#include "playback/recording_reader.h"

namespace ribbon {

// Does the curve (3 x at least 2) go round the object? It does where some full turn of it about the
// axis passes the object, that is, where the axis pierces a flat disc that the turn borders between
// the object's ends (of a turn that is not flat, about there).
bool embraces(const ObjectAxis& axis, const Eigen::Matrix3Xd& curve);

// How far from the object the knot sits: the rows whose middles come nearest to other parts of the
// ribbon. Nothing where none comes nearer than half the ribbon's width. positions: 3 x particles.
std::optional<double> knot_distance_m(const RecordingHeader& header,
                                      const Eigen::Matrix3Xf& positions,
                                      const TriangleMesh& object);

struct Outcome {
  struct Moment {
    int frame = 0;  // from 1
    double time_s = 0;
  };

  bool embraces_object = false;  // in the last frame
  // The first frame in which the ribbon no longer embraces the object, if it does in the first
  // frame of all and not in the last.
  std::optional<Moment> slipped_off = std::nullopt;
  std::optional<double> knot_distance_m = std::nullopt;  // in the last frame
};

// Looks at some ten frames. Nothing without an object on or beside a centre axis, and without a
// frame that can be read.
std::optional<Outcome> outcome(RecordingReader& reader);

// Such as "slipped off the object at 9.50 s, the knot 12.5 mm from it".
std::string outcome_text(const Outcome& outcome);

}  // namespace ribbon
