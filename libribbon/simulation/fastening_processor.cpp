#include "simulation/fastening_processor.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "ribbon_mesh/fabric_springs.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"
#include "simulation/contact/contact_extent.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/contact/pair_distances.h"
#include "simulation/detection/bodies.h"
#include "simulation/fastening/hands.h"
#include "simulation/fastening/staged_hands.h"
#include "simulation/fastening/two_hands.h"
#include "simulation/start/free_start.h"
#include "simulation/start/inside_obstacle.h"
#include "simulation/start/scene_limits.h"
#include "simulation/state/cloth.h"
#include "simulation/state/edge_strain.h"
#include "simulation/state/state_archive.h"
#include "simulation/step/published_step.h"
#include "simulation/step/time_step.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

// Of STATE.md. Raised whenever the layout changes, and whenever equal states no longer go on to
// equal bits.
constexpr std::int64_t state_version = 19;
constexpr std::int64_t most_steps = 4'000'000'000;
constexpr double longest_s = 1e9;

std::optional<ObstacleBody> obstacle_body(const std::optional<TriangleMesh>& obstacle) {
  if (!obstacle) return std::nullopt;
  return ObstacleBody(obstacle->triangles, obstacle->vertices.cast<double>());
}

// What the bytes are, and for whom.
struct StateHead {
  RibbonGrid grid;
  int fastened = 0;  // 0: not; 1: as a whole; 1 + n: in n stages
  double step_s = 0;
  double reach_m = 0;
};

void visit_head(StateArchive& archive, StateHead& head) {
  auto& [grid, fastened, step_s, reach_m] = head;
  const auto agree = [&archive](std::int64_t expected, const char* problem) {
    std::int64_t found = expected;
    archive.visit(found, std::numeric_limits<std::int64_t>::min(),
                  std::numeric_limits<std::int64_t>::max());
    if (found != expected) archive.refuse(problem);
  };
  agree(state_version, "it was written by another version of the simulation");
  agree(grid.along, "it has another number of particles along");
  agree(grid.across, "it has another number of particles across");
  agree(fastened, fastened == 0   ? "its ribbon is fastened"
                  : fastened == 1 ? "nothing fastens its ribbon, or stages do"
                                  : "it has another number of stages");
  archive.visit(step_s);
  archive.visit(reach_m);
  if (reach_m < 0) archive.refuse("it reaches nowhere");
}

int fastened(const Scene& scene) {
  return scene.fastening ? 1 + static_cast<int>(scene.stages.size()) : 0;
}

void visit_start(StateArchive& archive, StartReport& start) {
  auto& [kind, recovery_iterations, penetrating_edges] = start;
  constexpr int most = std::numeric_limits<int>::max();
  int number = static_cast<int>(kind);
  archive.visit(number, 0, static_cast<int>(StartKind::recovered));
  kind = static_cast<StartKind>(number);
  archive.visit(recovery_iterations, 0, most);
  archive.visit(penetrating_edges, 0, most);
}

}  // namespace

// What a simulation consists of.
struct FasteningProcessor::Parts {
  Parts(const Scene& scene, const RestSize& rest_size, const ContactLengths& lengths,
        const std::optional<TriangleMesh>& obstacle, Matrix3Xd positions);

  Result<void> find_start(const Scene& scene, const RibbonMesh& ribbon,
                          const ContactLengths& lengths, const StartObserver& observer,
                          const StartTest& test);
  StartReport recover_as_published(const Scene& scene);
  void employ_hands(const Scene& scene);
  void look_at_loose_ends();
  void go_on_with_other_steps(double other_step_s);
  void visit_state(StateArchive& archive, Changed changed);

  double step_s;
  SpringNetwork springs;
  std::int64_t steps = 0;
  std::int64_t steps_before = 0;  // with another step
  double before_s = 0;            // that they took
  Cloth cloth;
  Bodies bodies;
  std::unique_ptr<TimeStep> time_step;
  std::unique_ptr<Hands> hands;   // null where nothing fastens the ribbon
  StagedHands* staged = nullptr;  // the same, where there are stages
  int fastened_as = 0;            // StateHead::fastened
  RestSize size;
  PairDistances distances;
  StartReport start;
  double guaranteed_gap_m = 0;
  double reach_m = 0;
  double rounding_m;  // by which recording may move each coordinate
};

FasteningProcessor::Parts::Parts(const Scene& scene, const RestSize& rest_size,
                                 const ContactLengths& lengths,
                                 const std::optional<TriangleMesh>& obstacle, Matrix3Xd positions)
    : step_s(scene.time.step_s),
      springs(spring_network(rest_size, scene.springs)),
      cloth{std::move(positions), Matrix3Xd::Zero(3, rest_size.grid.particle_count()),
            scene.ribbon.mass_kg / rest_size.grid.particle_count(), lightness(rest_size)},
      bodies(rest_size.grid, obstacle_body(obstacle)),
      time_step(create_time_step(scene, rest_size, lengths, cloth.particle_mass_kg)),
      size(rest_size),
      distances(size, lengths),
      rounding_m(lengths.rounding_m) {}

FasteningProcessor::FasteningProcessor(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
FasteningProcessor::FasteningProcessor(FasteningProcessor&& other) noexcept = default;
FasteningProcessor& FasteningProcessor::operator=(FasteningProcessor&& other) noexcept = default;
FasteningProcessor::~FasteningProcessor() = default;

// ---- The start

Result<FasteningProcessor> FasteningProcessor::create(const Scene& as_read,
                                                      const RibbonMesh& ribbon,
                                                      const std::optional<TriangleMesh>& obstacle,
                                                      const StartObserver& observer,
                                                      const StartTest& test) {
  const RestSize size = ribbon.size();
  const double reach_m = recorded_reach_m(as_read, size, ribbon.positions);
  const Scene scene = with_fabric(with_rounding(as_read, size, reach_m), size);
  const ContactLengths lengths = contact_lengths(scene, size);
  auto possible = check_precision(as_read, size, lengths, ribbon.positions, obstacle);
  if (possible) possible = check_width(as_read, ribbon.grid);
  if (possible) possible = check_fabric(as_read, size);
  if (possible && obstacle) possible = check_outside(as_read, ribbon, *obstacle);
  if (!possible) return tl::unexpected(possible.error());
  auto parts = std::make_unique<Parts>(scene, size, lengths, obstacle, ribbon.positions);
  parts->reach_m = reach_m;
  const auto found = parts->find_start(scene, ribbon, lengths, observer, test);
  if (!found) return tl::unexpected(found.error());
  return FasteningProcessor(std::move(parts));
}

Result<void> FasteningProcessor::Parts::find_start(const Scene& scene, const RibbonMesh& ribbon,
                                                   const ContactLengths& lengths,
                                                   const StartObserver& observer,
                                                   const StartTest& test) {
  if (auto few = check_substeps(scene, springs, time_step->integrator()); !few) return few;
  if (scene.contact == ContactMethod::gate) {
    const auto found = find_free_start(scene, ribbon, lengths, observer, test, bodies, cloth);
    if (!found) return tl::unexpected(found.error());
    start = *found;
    guaranteed_gap_m = recorded_gap_m(lengths);
  } else {
    start = recover_as_published(scene);
  }
  employ_hands(scene);
  return {};
}

void FasteningProcessor::Parts::employ_hands(const Scene& scene) {
  fastened_as = fastened(scene);
  if (fastened_as == 0) return;
  if (fastened_as == 1) {
    hands = std::make_unique<TwoHands>(scene, size, cloth);
    return;
  }
  auto in_stages = std::make_unique<StagedHands>(scene, size, cloth);
  staged = in_stages.get();
  hands = std::move(in_stages);
}

// A band that was bent into a drawn curve is strained here and there, and may be pierced. Before
// the first step it is corrected and recovered as after any other, without force and at rest.
StartReport FasteningProcessor::Parts::recover_as_published(const Scene& scene) {
  PublishedStep step(scene, size, cloth.particle_mass_kg);
  const StepReport report = step.settle(settling_rounds, bodies, cloth);
  return {.kind = report.recovery_iterations > 0 ? StartKind::recovered : StartKind::free,
          .recovery_iterations = report.recovery_iterations,
          .penetrating_edges = report.penetrating_edges};
}

const StartReport& FasteningProcessor::start() const {
  return parts_->start;
}

// ---- The steps

IntegrationMethod FasteningProcessor::integrator() const {
  return parts_->time_step->integrator().method();
}

int FasteningProcessor::substeps() const {
  return parts_->time_step->integrator().substeps();
}

StepReport FasteningProcessor::step() {
  ++parts_->steps;
  if (parts_->staged != nullptr) {
    parts_->staged->begin_step(parts_->cloth);
    parts_->time_step->set_friction(parts_->staged->friction());
    parts_->time_step->set_gravity(parts_->staged->gravity_m_s2());
  }
  const StepReport report =
      parts_->time_step->take(parts_->hands.get(), parts_->bodies, parts_->cloth);
  if (parts_->staged != nullptr && parts_->staged->guard_is_due()) parts_->look_at_loose_ends();
  return report;
}

// Costs a detection, unless hands hold both ends.
void FasteningProcessor::Parts::look_at_loose_ends() {
  const std::array<bool, 2> held = staged->have_ends();
  LooseEnds ends;
  if (!held[0] || !held[1])
    ends = contact_extent(bodies, size, distances, cloth.positions).loose_ends_m;
  for (std::size_t end = 0; end < ends.size(); ++end)
    if (held[end]) ends[end].reset();
  staged->guard().look(ends);
}

double FasteningProcessor::time_s() const {
  return parts_->before_s +
         static_cast<double>(parts_->steps - parts_->steps_before) * parts_->step_s;
}

std::int64_t FasteningProcessor::steps() const {
  return parts_->steps;
}

std::int64_t FasteningProcessor::steps_at(double time_s) const {
  const double steps = (time_s - parts_->before_s) / parts_->step_s;
  return parts_->steps_before + static_cast<std::int64_t>(std::ceil(steps - 1e-9 * (1 + steps)));
}

const PhaseSums& FasteningProcessor::phase_sums() const {
  return parts_->time_step->phase_sums();
}

// ---- What became of the ribbon

const Matrix3Xd& FasteningProcessor::positions() const {
  return parts_->cloth.positions;
}

double FasteningProcessor::strain() const {
  return worst_strain(parts_->springs, parts_->cloth.positions);
}

std::optional<Tightness> FasteningProcessor::tightness() {
  if (!parts_->hands) return std::nullopt;
  const ContactExtent contact =
      contact_extent(parts_->bodies, parts_->size, parts_->distances, parts_->cloth.positions);
  return Tightness{.progress = parts_->hands->progress(),
                   .contact_share = contact.share,
                   .rope_length = contact.knotted_m / parts_->size.width_m};
}

bool FasteningProcessor::is_tight() const {
  return parts_->hands && parts_->hands->are_done();
}

std::optional<int> FasteningProcessor::stage() const {
  if (parts_->staged == nullptr) return std::nullopt;
  return parts_->staged->stage();
}

bool FasteningProcessor::stages_are_over() const {
  return parts_->staged != nullptr && parts_->staged->are_over();
}

std::vector<int> FasteningProcessor::stages_given_up() const {
  std::vector<int> stages;
  if (parts_->staged == nullptr) return stages;
  const std::vector<bool>& given_up = parts_->staged->given_up();
  for (int i = 0; i < std::ssize(given_up); ++i)
    if (given_up[i]) stages.push_back(i);
  return stages;
}

std::optional<int> FasteningProcessor::slipping_end() const {
  if (parts_->staged == nullptr) return std::nullopt;
  return parts_->staged->guard().slipping_end();
}

double FasteningProcessor::reach_m() const {
  return parts_->reach_m;
}

double FasteningProcessor::max_position_error_m() const {
  const bool is_lossless = parts_->reach_m < std::numeric_limits<double>::max();
  return is_lossless ? 0 : parts_->rounding_m;
}

double FasteningProcessor::guaranteed_gap_m() const {
  return parts_->guaranteed_gap_m;
}

double FasteningProcessor::guaranteed_strain() const {
  return parts_->time_step->guaranteed_strain();
}

double FasteningProcessor::held_strain() const {
  return parts_->time_step->held_strain();
}

// ---- The state

std::string FasteningProcessor::state() {
  StateArchive archive;
  parts_->visit_state(archive, Changed::nothing);
  return archive.bytes();
}

Result<FasteningProcessor> FasteningProcessor::restore(const Scene& as_read, const RestSize& size,
                                                       const std::optional<TriangleMesh>& obstacle,
                                                       std::string_view state, Changed changed) {
  auto possible = check_width(as_read, size.grid);
  if (possible) possible = check_fabric(as_read, size);
  if (!possible) return tl::unexpected(possible.error());
  const auto refused = [&as_read](Error error) {
    error.place = as_read.name;
    return tl::unexpected(std::move(error));
  };
  StateHead head{.grid = size.grid, .fastened = fastened(as_read)};
  StateArchive beginning(state);
  visit_head(beginning, head);
  beginning.ignore_rest();
  if (auto read = beginning.finish(); !read) return refused(read.error());
  const Scene scene = with_fabric(with_rounding(as_read, size, head.reach_m), size);
  auto parts = std::make_unique<Parts>(scene, size, contact_lengths(scene, size), obstacle,
                                       Matrix3Xd::Zero(3, size.grid.particle_count()));
  if (auto few = check_substeps(scene, parts->springs, parts->time_step->integrator()); !few)
    return tl::unexpected(few.error());
  parts->employ_hands(scene);
  StateArchive archive(state);
  parts->visit_state(archive, changed);
  if (auto read = archive.finish(); !read) return refused(read.error());
  return FasteningProcessor(std::move(parts));
}

void FasteningProcessor::Parts::visit_state(StateArchive& archive, Changed changed) {
  auto& [step_of_scene, springs_of_scene, steps_now, steps_then, then_s, cloth_now, bodies_now,
         time_step_of_scene, hands_now, staged_hands_now, fastened_as_of_scene, size_of_scene,
         distances_of_scene, start_then, gap_m, reach_then_m, rounding_of_scene] = *this;
  StateHead head{size.grid, fastened_as_of_scene, step_s, reach_m};
  visit_head(archive, head);
  reach_then_m = head.reach_m;
  archive.visit(steps_now, 0, most_steps);
  archive.visit(steps_then, 0, steps_now);
  archive.visit(then_s);
  if (then_s < 0 || then_s > longest_s) archive.refuse("its steps took an impossible time");
  archive.visit(gap_m);
  visit_start(archive, start_then);
  cloth_now.visit_state(archive);
  bodies_now.visit_state(archive);
  if (hands_now) hands_now->visit_state(archive);
  if (changed == Changed::nothing) {
    if (head.step_s != step_s) archive.refuse("it was made with another time.step");
    if (hands_now) hands_now->visit_memory(archive);
    return;
  }
  archive.ignore_rest();
  go_on_with_other_steps(head.step_s);
  if (staged_hands_now && changed == Changed::hands) staged_hands_now->begin_anew(cloth_now);
}

// The clock of the scene that comes takes over from the one whose steps took other_step_s.
void FasteningProcessor::Parts::go_on_with_other_steps(double other_step_s) {
  if (other_step_s == step_s) return;
  before_s += static_cast<double>(steps - steps_before) * other_step_s;
  steps_before = steps;
}

}  // namespace ribbon
