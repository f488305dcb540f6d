#include "simulation/truncation/contact_constraints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/vectors.h"
#include "parallel/parallel.h"
#include "simulation/contact/friction.h"
#include "simulation/detection/closest_weights.h"
#include "simulation/detection/locally_closest.h"
#include "simulation/truncation/approach.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Corners = Eigen::Matrix<double, 3, 4>;

namespace {

// Beyond the minimum separation, so that nothing has to be truncated.
constexpr double clear_of_truncation = 1.2;
// Of what lacks to the activation distance: layers that were pressed together move apart gently.
constexpr double opening = 0.2;
constexpr double negligible_violation = 0.03;  // of a distance
constexpr double hardly = 0.1;                 // of a distance: a way that turns no normal
// Of a distance: more than rounding can take from how far something is and has travelled.
constexpr double doubtful = 1e-6;

// Of the closest points of a pair.
struct Contact {
  Vector4d weights;  // at the start of its motion
  Vector3d normal;
  Vector4d weights_then;  // when the line between the closest points lies along the normal
};

// The normal is that of the start, but of a pair that would come near, as that normal has it, the
// one of its closest approach, or of when it is down to the minimum separation: of features that
// slide past each other, or meet beside where they are closest now, the former lies aslant. What
// hardly moves keeps to the former, lest a normal turn with every tremor. None where the closest
// points leave no direction.
std::optional<Contact> contact_of(FeaturePair::Kind kind, const Corners& start,
                                  const Vector4d& weights, const Corners& displacement,
                                  double near_m, double min_separation_m) {
  const Vector3d apart = weighted_sum(start, weights);
  const double distance_m = length_of(apart);
  if (distance_m == 0) return std::nullopt;
  const Contact at_start{weights, apart / distance_m, weights};
  const Vector3d way = weighted_sum(displacement, weights);
  if (length_of(way) < hardly * distance_m) return at_start;
  const double approach_m = -dot(at_start.normal, way);
  if (approach_m <= 0 || distance_m - approach_m >= near_m) return at_start;

  const Approach met = approach_down_to(min_separation_m, kind, start, weights, displacement);
  return Contact{weights, met.apart / length_of(met.apart), closest_weights(kind, met.corners)};
}

// The distance to be kept where there is this one.
double kept_distance_m(double distance_m, double activation_m, double min_separation_m) {
  const double opened_m = distance_m + opening * std::max(0.0, activation_m - distance_m);
  return std::min(activation_m, std::max(opened_m, clear_of_truncation * min_separation_m));
}

// That distance, of which contact opens a fraction only.
double eased_m(double kept_m, double distance_m, double fraction) {
  return kept_m > distance_m && fraction < 1 ? distance_m + fraction * (kept_m - distance_m)
                                             : kept_m;
}

ContactConstraint constraint_of(const FeaturePair& pair, const Contact& contact, double kept_m,
                                const Bodies& bodies, const Eigen::ArrayXd& lightness) {
  ContactConstraint constraint;
  constraint.vertices = pair.vertices;
  constraint.weights = contact.weights;
  for (int k = 0; k < 4; ++k)
    constraint.corrections[k] = bodies.is_particle(pair.vertices[k]) ? contact.weights[k] : 0;
  for (int k = 0; k < 4 && lightness.size() > 0; ++k)
    if (constraint.corrections[k] != 0) constraint.corrections[k] *= lightness[pair.vertices[k]];
  constraint.corrections /= dot(constraint.corrections, constraint.weights);
  constraint.normal = contact.normal;
  constraint.distance_m = kept_m;
  return constraint;
}

// Those that lift a vertex of the ribbon off the obstacle come first: while its neighbours are
// still down, those of edges and triangles would lift it too far.
void put_in_order(const std::vector<std::size_t>& listed, const ContactCandidates& candidates,
                  const Bodies& bodies, std::vector<std::size_t>& order) {
  const auto lifts_a_vertex = [&](const FeaturePair& pair) {
    return pair.kind == FeaturePair::Kind::vertex_triangle &&
           bodies.is_particle(pair.vertices[0]) && !bodies.is_particle(pair.vertices[1]);
  };
  order.clear();
  for (const bool first : {true, false})
    for (const std::size_t i : listed)
      if (lifts_a_vertex(candidates.pairs[i]) == first) order.push_back(i);
}

}  // namespace

void ContactConstraints::find(const ContactCandidates& candidates, const Bodies& bodies,
                              const PairDistances& distances, double beyond_m,
                              const Matrix3Xd& free_positions, const Matrix3Xd& target,
                              const Vector3d& fall_m) {
  const VertexPositions vertices = bodies.vertices(free_positions);
  displacement_ = target - free_positions;
  const bool falls = !fall_m.isZero(0);
  if (falls) falling_ = displacement_.colwise() + fall_m;
  put_in_order(approaching_.find(candidates, free_positions, falls ? falling_ : displacement_,
                                 distances.activation_reach(beyond_m), RestingPairs::found),
               candidates, bodies, order_);
  found_.resize(order_.size());
  parallel_ranges(order_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const FeaturePair& pair = candidates.pairs[order_[i]];
      const Corners start = corners(pair, vertices);
      const double activation_m = distances.activation_m(pair);
      const double min_separation_m = distances.min_separation_m(pair);
      const std::optional<Contact> contact =
          contact_of(pair.kind, start, approaching_.weights(order_[i], candidates, start),
                     displacements(pair, displacement_), activation_m + beyond_m, min_separation_m);
      found_[i].distance_m = 0;  // of none
      if (!contact ||
          !are_locally_closest(pair, contact->weights_then, contact->normal, vertices, bodies))
        continue;
      const double distance_m = dot(contact->normal, weighted_sum(start, contact->weights));
      const double kept_m = eased_m(kept_distance_m(distance_m, activation_m, min_separation_m),
                                    distance_m, opened_fraction_);
      found_[i] = constraint_of(pair, *contact, kept_m, bodies, lightness_);
    }
  });
  std::erase_if(found_, [](const ContactConstraint& found) { return found.distance_m == 0; });
  watches_.resize(found_.size());
  for (std::size_t i = 0; i < found_.size(); ++i)
    for (int k = 0; k < 4; ++k)
      watches_[i].vertices[k] = std::min(found_[i].vertices[k], bodies.grid.particle_count());
}

namespace {

// The contact point of the first feature as seen from that of the second; the obstacle's vertices
// do not move.
template <class Of>
Vector3d between(const ContactConstraint& constraint, const Bodies& bodies, const Of& of) {
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < 4; ++k)
    if (bodies.is_particle(constraint.vertices[k]))
      sum += constraint.weights[k] * of(constraint.vertices[k]);
  return sum;
}

// How far a pair is to move apart, and what its velocity is to change by.
struct Response {
  Vector3d moved;
  Vector3d accelerated;
};

Response response(const ContactConstraint& constraint, double violation_m, double friction,
                  const Matrix3Xd& before, const Bodies& bodies, const Cloth& cloth) {
  const Vector3d& normal = constraint.normal;
  const Vector3d velocity = between(
      constraint, bodies, [&](int particle) -> Vector3d { return cloth.velocities.col(particle); });
  const double stopped_m_s = std::max(0.0, -dot(normal, velocity));
  Response result{violation_m * normal, stopped_m_s * normal};
  if (friction > 0) {
    const Vector3d slid = between(constraint, bodies, [&](int particle) -> Vector3d {
      return cloth.positions.col(particle) - before.col(particle);
    });
    result.moved += friction_impulse(slid, normal, friction, violation_m);
    result.accelerated += friction_impulse(velocity, normal, friction, stopped_m_s);
  }
  return result;
}

}  // namespace

void ContactConstraints::begin_sweeps() {
  for (Watch& watch : watches_) watch.kept_until_m = -1;
}

bool ContactConstraints::keep_apart(double friction, const Matrix3Xd& before, const Bodies& bodies,
                                    SweepActivity& activity, Cloth& cloth) {
  const VertexPositions vertices = bodies.vertices(cloth.positions);
  bool any = false;
  activity.begin(contact_task);
  const ContactConstraint* next = found_.data();
  for (Watch& watch : watches_) {
    const ContactConstraint& constraint = *next++;
    const double travelled_m = activity.travelled_m(watch.vertices);
    if (travelled_m <= watch.kept_until_m) continue;
    double distance_m = 0;
    for (int k = 0; k < 4; ++k)
      distance_m +=
          constraint.weights[k] * dot(constraint.normal, vertices[constraint.vertices[k]]);
    const double violation_m = constraint.distance_m - distance_m;
    watch.kept_until_m = travelled_m - violation_m - doubtful * constraint.distance_m;
    if (violation_m <= 0) continue;
    any = any || violation_m > negligible_violation * constraint.distance_m;
    const auto [moved, accelerated] =
        response(constraint, violation_m, friction, before, bodies, cloth);
    const double moved_m = length_of(moved);
    for (int k = 0; k < 4; ++k) {
      if (constraint.corrections[k] == 0) continue;
      const int particle = constraint.vertices[k];
      cloth.positions.col(particle) += constraint.corrections[k] * moved;
      cloth.velocities.col(particle) += constraint.corrections[k] * accelerated;
      activity.move(particle, std::abs(constraint.corrections[k]) * moved_m);
    }
  }
  return any;
}

}  // namespace ribbon
