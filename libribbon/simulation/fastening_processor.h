// The fastening deformation processor (paper, section 5, Figure 5).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/rest_size.h"
#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "scene/integration_method.h"
#include "simulation/start/start_report.h"
#include "simulation/step/step_clock.h"
#include "simulation/step/step_report.h"

namespace ribbon {

struct RibbonMesh;
struct Scene;

// What is other than before where a run goes on; `hands`: settings, and the hands of the present
// stage as well.
enum class Changed { nothing, settings, hands };

// How tight the ribbon is now (paper, section 7).
struct Tightness {
  double progress = 1;       // in the last two seconds, against a free ribbon; 1: free, 0: locked
  double contact_share = 0;  // of the rows, that touch another part of the ribbon or the obstacle
  double rope_length = 0;    // rest length of the knotted part over the ribbon's width
};

// Fastens one ribbon, step by step. What the scene does not name (springs, obstacle, fastening) is
// neither held in memory nor computed. Equal scenes give equal bits for any number of threads.
class FasteningProcessor {
 public:
  // With the gate the ribbon starts free of intersections, and so stays free. As published, the
  // schemes recover what they can at the start too, and what is left is counted. Fails, with the
  // scene's name, where there is no free start (free_start.h), where the ribbon lies inside the
  // obstacle (inside_obstacle.h) and where numbers could not hold what is promised
  // (scene_limits.h). The search for a start may take minutes, and tells the observer;
  // a ribbon that lets go of its strain is put to the test.
  static Result<FasteningProcessor> create(const Scene& as_read, const RibbonMesh& ribbon,
                                           const std::optional<TriangleMesh>& obstacle,
                                           const StartObserver& observer = {},
                                           const StartTest& test = {});

  // Goes on from a state() of the same scene, ribbon size and obstacle to the same bits as the
  // processor that was asked for it. With changed settings, which may be any but the ribbon, the
  // obstacle, the contact, the recording's rounding and whether there is fastening, from the same
  // places and speeds; tightness is then measured anew. A stage that has reached its goal is over
  // all the same; one that is over begins anew where its hands change. The number of stages cannot
  // change. Fails where the state is not one of such a scene, and where springs and air divide each
  // step into too many parts.
  static Result<FasteningProcessor> restore(const Scene& as_read, const RestSize& size,
                                            const std::optional<TriangleMesh>& obstacle,
                                            std::string_view state,
                                            Changed changed = Changed::nothing);

  FasteningProcessor(FasteningProcessor&& other) noexcept;
  FasteningProcessor& operator=(FasteningProcessor&& other) noexcept;
  ~FasteningProcessor();

  // Everything that the next steps depend on and the scene does not tell (STATE.md).
  [[nodiscard]] std::string state();

  // How the ribbon came to its start.
  [[nodiscard]] const StartReport& start() const;

  // What computes the displacement of a step: what the scene names or, where it names nothing, what
  // suits its springs. And into how many parts that divided the last step; 1 before the first one
  // of the implicit scheme.
  [[nodiscard]] IntegrationMethod integrator() const;
  [[nodiscard]] int substeps() const;

  StepReport step();

  // Largest |length / rest length - 1| of the stretch and shear springs now.
  [[nodiscard]] double strain() const;

  // Costs a detection. Nothing where the scene has no fastening.
  std::optional<Tightness> tightness();

  // Has the ribbon come to a stop although it is pulled? Of stages: in the last one. Never without
  // a fastening.
  [[nodiscard]] bool is_tight() const;

  // The stage of the last step, from 0, and the last one also when all are over; nothing where the
  // scene has none.
  [[nodiscard]] std::optional<int> stage() const;
  // Are all stages over? Never without them.
  [[nodiscard]] bool stages_are_over() const;
  // Those, from 0, whose `at_most` was over before all was tight, or had arrived.
  [[nodiscard]] std::vector<int> stages_given_up() const;
  // The end of the ribbon, 0 or 1, that was about to slip out of its knot when the hands of a stage
  // let go.
  [[nodiscard]] std::optional<int> slipping_end() const;

  // A recording without loss (max_position_error = 0) keeps the guaranteed gap as long as no
  // coordinate of a particle is farther from 0 than this: several times as far as at the start.
  // Otherwise the largest number.
  [[nodiscard]] double reach_m() const;

  // By how much recording may move each coordinate: the scene's max_position_error, or what suits
  // the ribbon's edges where it names none. 0: only by rounding it to single precision.
  [[nodiscard]] double max_position_error_m() const;

  // No two features that share no vertex, of the ribbon or of ribbon and obstacle, come nearer than
  // this, even if each coordinate of a particle is moved by that error, or rounded to single
  // precision where it is 0. 0 with contact = "paper", which guarantees
  // nothing.
  [[nodiscard]] double guaranteed_gap_m() const;

  // No limited edge (limited_edges()) is further from its rest length than this fraction of it,
  // with the same allowance. 0 with contact = "paper", which guarantees nothing.
  [[nodiscard]] double guaranteed_strain() const;
  // To what edges are held in the steps so that this is kept as recorded: of some to less than of
  // others, where that is coarse. Infinite where none are.
  [[nodiscard]] double held_strain() const;

  // Where the time of all steps went.
  [[nodiscard]] const PhaseSums& phase_sums() const;

  // 3 x particles, metres.
  [[nodiscard]] const Eigen::Matrix3Xd& positions() const;
  [[nodiscard]] double time_s() const;
  // Since the start.
  [[nodiscard]] std::int64_t steps() const;
  // How many there are at the first step at or after a time. A time that falls on a step up to
  // rounding is on it.
  [[nodiscard]] std::int64_t steps_at(double time_s) const;

 private:
  struct Parts;  // so that callers need not know what a simulation consists of

  explicit FasteningProcessor(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace ribbon
