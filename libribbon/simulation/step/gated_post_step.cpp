#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "simulation/contact/collision_response.h"
#include "simulation/step/post_step.h"
#include "simulation/truncation/contact_constraints.h"
#include "simulation/truncation/gate.h"
#include "simulation/truncation/strain_limit.h"
#include "simulation/truncation/surroundings.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr int repulsion_rounds = 3;
// Layers that move together let each other pass one by one.
constexpr int passages = 4;

constexpr int surveys_of_stragglers = 3;  // before all particles count as such

StrainLimit strain_limit(const PostStepProperties& properties) {
  std::vector<LimitedFamily> limited;
  const auto limit = [&](const SpringFamily& family) {
    limited.push_back({family, aimed_strain(properties.smoothing.strain, family.rest_length_m,
                                            properties.rounding_m)});
  };
  for (const SpringFamily& family : stretch_families(properties.size)) limit(family);
  if (properties.resists_shear)
    for (const SpringFamily& family : shear_families(properties.size)) limit(family);
  return {properties.size.grid, std::move(limited)};
}

class GatedPostStep : public PostStep {
 public:
  GatedPostStep(Bodies& bodies, const PostStepProperties& properties, StageClock& clock)
      : bodies_(bodies),
        clock_(clock),
        gaps_(properties.size, gap_lengths(properties.size.shortest_edge_m(), properties.rounding_m,
                                           properties.thickness_m)),
        repulsion_settings_{.friction = properties.friction},
        survey_lengths_{.reach_m = gaps_.largest_contact_m(),
                        .slack_m = 0.1 * properties.size.shortest_edge_m(),
                        .longest_way_m = 4 * properties.size.shortest_edge_m()},
        smoothing_(properties.smoothing),
        strain_limit_(strain_limit(properties)),
        negligible_m_(0.01 * properties.size.shortest_edge_m()),
        step_s_(properties.step_s) {}

  PostStepReport correct(const Matrix3Xd& before, Cloth& cloth) override {
    certified_ = before;
    detect(cloth);
    clock_.charge(Stage::repulsion);
    repel(cloth);
    PostStepReport report{.is_over_limit = true};
    for (int round = 0; round < smoothing_.most_rounds && report.is_over_limit; ++round) {
      clock_.charge(Stage::smoothing);
      smooth(cloth);
      detect_if_outgrown(round > 0, cloth);
      clock_.charge(Stage::errors);
      report.held_back = std::max(report.held_back, pass(cloth));
      report.is_over_limit = strain_limit_.worst_excess(cloth.positions) > strain_left_over;
    }
    return report;
  }

 private:
  // Around the way from the certified to the wished positions.
  void detect(const Cloth& cloth) {
    clock_.charge(Stage::detection);
    surroundings_ = {};  // not to hold two at a time
    surroundings_ = survey(bodies_, survey_lengths_, certified_, cloth.positions);
    clock_.count_detection(surroundings_.pairs.size());
  }

  // Again around some particles.
  void detect_around(const std::vector<int>& particles, Widening widening, const Cloth& cloth) {
    clock_.charge(Stage::detection);
    widen(particles, widening, bodies_, survey_lengths_, cloth.positions, surroundings_);
    clock_.count_detection(surroundings_.pairs.size());
  }

  // A few particles that wish to leave their ranges are held back, which may strain their edges;
  // many are worth another look, and any when edges are strained.
  void detect_if_outgrown(bool is_strained, const Cloth& cloth) {
    const std::vector<int> outside = vertices_outside(surroundings_, cloth.positions);
    const auto few = static_cast<std::size_t>(is_strained ? 0 : cloth.particle_count() / 100);
    if (outside.size() > few) detect_around(outside, Widening::onward, cloth);
  }

  // while ∃ collision: update velocity, displacement.
  void repel(Cloth& cloth) {
    std::vector<FeaturePair> pairs;
    for (const std::size_t i :
         approaching_pairs(surroundings_, certified_, cloth.positions - certified_, reach_m()))
      pairs.push_back(surroundings_.pairs[i]);
    for (int round = 0; round < repulsion_rounds; ++round)
      if (!repel_once(pairs, gaps_, repulsion_settings_, certified_, cloth)) return;
  }

  // while ∃ over-stretched edge: apply post-step correction. Corrected alone, edges would be
  // pressed into contact, and stretched again by it; so both are satisfied in turn. What moves the
  // particles also changes their velocities.
  void smooth(Cloth& cloth) const {
    const Matrix3Xd before = cloth.positions;
    const auto contacts = contact_constraints(surroundings_, gaps_, reach_m(), certified_, cloth);
    RowActivity activity = strain_limit_.activity();
    bool any = true;
    int sweeps = 0;
    for (; sweeps < smoothing_.most_sweeps && any; ++sweeps) {
      any = keep_apart(contacts, bodies_.grid, activity, cloth.positions);
      any = strain_limit_.tighten(activity, cloth.positions) || any;
    }
    clock_.count_sweeps(sweeps);
    cloth.velocities += (cloth.positions - before).leftCols(cloth.particle_count()) / step_s_;
  }

  // From the certified positions toward the cloth's wish, as far as the gate lets: no errors to
  // recover from. Returns how many did not get all of their way.
  int pass(Cloth& cloth) {
    Passage passage;
    for (int i = 0; i < passages; ++i) {
      passage = pass_once(cloth);
      if (passage.held_back == 0 || passage.farthest_m < negligible_m_) break;
    }
    stop_what_is_held_back(cloth);
    cloth.positions = certified_;
    return passage.held_back;
  }

  // Stragglers get ranges that reach back to where they were, until there are none: at last all
  // particles do.
  Passage pass_once(const Cloth& cloth) {
    Passage passage = pass_gate(surroundings_, gaps_, cloth.positions, certified_);
    for (int again = 1; !passage.stragglers.empty(); ++again) {
      if (again > surveys_of_stragglers) {
        passage.stragglers.resize(static_cast<std::size_t>(cloth.particle_count()));
        std::iota(passage.stragglers.begin(), passage.stragglers.end(), 0);
      }
      detect_around(passage.stragglers, Widening::onward_and_back, cloth);
      clock_.charge(Stage::errors);
      passage = pass_gate(surroundings_, gaps_, cloth.positions, certified_);
    }
    return passage;
  }

  // What the gate held back is taken from the velocity, as far as there is any in that direction: a
  // repulsion or smoothing that did not get through must not throw a particle the other way.
  void stop_what_is_held_back(Cloth& cloth) const {
    for (Eigen::Index particle = 0; particle < cloth.particle_count(); ++particle) {
      const Eigen::Vector3d held = cloth.positions.col(particle) - certified_.col(particle);
      const double held_m = held.norm();
      const double speed_m_s = held_m > 0 ? held.dot(cloth.velocities.col(particle)) / held_m : 0;
      if (speed_m_s > 0)
        cloth.velocities.col(particle) -= std::min(speed_m_s, held_m / step_s_) * held / held_m;
    }
  }

  // Pairs this close may come into contact by what still moves them.
  [[nodiscard]] double reach_m() const { return survey_lengths_.reach_m + survey_lengths_.slack_m; }

  Bodies& bodies_;
  StageClock& clock_;
  PairGaps gaps_;
  RepulsionSettings repulsion_settings_;
  SurveyLengths survey_lengths_;
  SmoothingScene smoothing_;
  StrainLimit strain_limit_;
  double negligible_m_;
  double step_s_;
  Matrix3Xd certified_;  // positions that the gate has let pass
  Surroundings surroundings_;
};

}  // namespace

std::unique_ptr<PostStep> gated_post_step(Bodies& bodies, const PostStepProperties& properties,
                                          StageClock& clock) {
  return std::make_unique<GatedPostStep>(bodies, properties, clock);
}

}  // namespace ribbon
