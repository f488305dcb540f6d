// What follows the displacement within a step: collisions, smoothing and errors (paper, Figure 5,
// sections 5.4 to 5.6).
#pragma once

#include <Eigen/Core>
#include <memory>

#include "ribbon_mesh/rest_size.h"
#include "scene/scene.h"
#include "simulation/detection/bodies.h"
#include "simulation/state/cloth.h"
#include "simulation/step/stage_clock.h"

namespace ribbon {

// What the post-step needs to know of a ribbon and its recording.
struct PostStepProperties {
  RestSize size;
  double step_s = 0;              // turns corrections of positions into velocities
  bool resists_shear = true;      // are diagonals kept within the strain limit, too?
  double rounding_m = 0;          // how far recording may move a coordinate
  SmoothingScene smoothing = {};  // of the gated one
  double thickness_m = 0;         // of the cloth
  double friction = 0;            // Coulomb's coefficient
};

struct PostStepReport {
  int recovery_iterations = 0;  // how often scheme A, B or C was applied
  int penetrating_edges = 0;    // that it left; the gate lets none come about
  bool is_over_limit = false;  // is some edge still longer or shorter than the strain limit allows?
  int held_back = 0;  // particles that the gate did not let go all of their way, in the passage
                      // that held most
};

class PostStep {
 public:
  virtual ~PostStep() = default;

  // cloth.positions are where displacement from `before` (3 x vertices) brought the cloth; leaves
  // them where they may be, with velocities that agree.
  virtual PostStepReport correct(const Eigen::Matrix3Xd& before, Cloth& cloth) = 0;
};

// As published: collisions are repelled as far as they are found, smoothing may push the ribbon
// through itself, and schemes A, B and C bring it back as well as they can. `clock`, here and
// below, is charged with the stages, and must outlive the post-step.
std::unique_ptr<PostStep> published_post_step(Bodies& bodies, const PostStepProperties& properties,
                                              StageClock& clock);

// Collisions are repelled likewise, but smoothing knows of contact, and positions reach the cloth
// only through the gate, so that what did not intersect at the start never does.
std::unique_ptr<PostStep> gated_post_step(Bodies& bodies, const PostStepProperties& properties,
                                          StageClock& clock);

}  // namespace ribbon
