#include "simulation/fastening_processor.h"

#include <cmath>
#include <limits>
#include <utility>

#include "simulation/contact/contact_extent.h"
#include "simulation/contact/gap_lengths.h"
#include "simulation/start/scene_limits.h"
#include "simulation/start/width_growth.h"
#include "simulation/state/edge_strain.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

// Of STATE.md. Raised whenever the layout changes, and whenever equal states no longer go on to
// equal bits.
constexpr std::int64_t state_version = 1;
constexpr std::int64_t most_steps = 4'000'000'000;

// Particles first, the obstacle's vertices behind them.
Matrix3Xd all_vertices(const Matrix3Xd& particles, const std::optional<TriangleMesh>& obstacle) {
  Matrix3Xd all(3, particles.cols() + (obstacle ? obstacle->vertices.cols() : 0));
  all.leftCols(particles.cols()) = particles;
  if (obstacle) all.rightCols(obstacle->vertices.cols()) = obstacle->vertices.cast<double>();
  return all;
}

std::optional<ObstacleBody> obstacle_body(const std::optional<TriangleMesh>& obstacle,
                                          int first_vertex, const Matrix3Xd& positions) {
  if (!obstacle) return std::nullopt;
  return ObstacleBody(collision_surface(obstacle->triangles.array() + first_vertex), positions);
}

std::unique_ptr<Bodies> bodies_of(const RibbonGrid& grid,
                                  const std::optional<TriangleMesh>& obstacle,
                                  const Matrix3Xd& positions) {
  return std::make_unique<Bodies>(grid, obstacle_body(obstacle, grid.particle_count(), positions));
}

// What the bytes are, and for whom.
struct StateHead {
  RibbonGrid grid;
  bool is_fastened = false;
  double step_s = 0;
  double reach_m = 0;
};

void visit_head(StateArchive& archive, StateHead& head) {
  auto& [grid, is_fastened, step_s, reach_m] = head;
  const auto agree = [&archive](std::int64_t expected, const char* problem) {
    std::int64_t found = expected;
    archive.visit(found, std::numeric_limits<std::int64_t>::min(),
                  std::numeric_limits<std::int64_t>::max());
    if (found != expected) archive.refuse(problem);
  };
  agree(state_version, "it was written by another version of the simulation");
  agree(grid.along, "it has another number of particles along");
  agree(grid.across, "it has another number of particles across");
  agree(is_fastened ? 1 : 0, is_fastened ? "nothing fastens its ribbon" : "its ribbon is fastened");
  archive.visit(step_s);
  archive.visit(reach_m);
  if (reach_m < 0) archive.refuse("it reaches nowhere");
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

FasteningProcessor::FasteningProcessor(const Scene& scene, const RestSize& size,
                                       const std::optional<TriangleMesh>& obstacle,
                                       Matrix3Xd vertices)
    : step_s_(scene.time.step_s),
      springs_(spring_network(size, scene.springs)),
      cloth_{std::move(vertices), Matrix3Xd::Zero(3, size.grid.particle_count()),
             scene.ribbon.mass_kg / size.grid.particle_count()},
      bodies_(bodies_of(size.grid, obstacle, cloth_.positions)),
      deformation_(scene, size, cloth_.particle_mass_kg, *bodies_),
      size_(size),
      gaps_(size_, gap_lengths(size_.shortest_edge_m(),
                               scene.recording.max_position_error_m(size.length_m),
                               scene.ribbon.thickness_m)) {}

Result<FasteningProcessor> FasteningProcessor::create(const Scene& wished, const RibbonMesh& ribbon,
                                                      const std::optional<TriangleMesh>& obstacle) {
  const RestSize size = rest_size(ribbon, 1);
  Matrix3Xd vertices = all_vertices(ribbon.positions, obstacle);
  const auto precise = check_precision(wished, size, vertices);
  if (!precise) return tl::unexpected(precise.error());
  const auto narrow = check_width(wished, ribbon.grid);
  if (!narrow) return tl::unexpected(narrow.error());
  const double reach_m = recorded_reach_m(wished, size, vertices);
  const Scene scene = with_single_rounding(wished, size, reach_m);
  FasteningProcessor processor(scene, size, obstacle, std::move(vertices));
  processor.reach_m_ = reach_m;
  const auto begun = processor.begin(scene, ribbon);
  if (!begun) return tl::unexpected(begun.error());
  return processor;
}

Result<void> FasteningProcessor::begin(const Scene& scene, const RibbonMesh& ribbon) {
  if (auto few = check_substeps(scene, deformation_.substeps()); !few) return few;
  if (scene.contact == ContactMethod::gate) {
    const auto start = find_free_start(scene, ribbon, *bodies_, deformation_, cloth_);
    if (!start) return tl::unexpected(start.error());
    start_ = *start;
    const double rounding_m = scene.recording.max_position_error_m(ribbon.length_m);
    guaranteed_gap_m_ =
        recorded_gap_m(gap_lengths(size_.shortest_edge_m(), rounding_m, 0), rounding_m);
  } else {
    start_ = recover_as_published();
  }
  if (scene.fastening) hands_.emplace(scene, size_, cloth_);
  deformation_.clock().reset();
  return {};
}

// A band that was bent into a drawn curve is strained here and there, and may be pierced. Before
// the first step it is corrected and recovered as after any other, without force and at rest.
StartReport FasteningProcessor::recover_as_published() {
  const PostStepReport report = deformation_.settle(settling_rounds, cloth_);
  return {.kind = report.recovery_iterations > 0 ? StartKind::recovered : StartKind::free,
          .recovery_iterations = report.recovery_iterations,
          .penetrating_edges = report.penetrating_edges};
}

Result<FasteningProcessor> FasteningProcessor::restore(const Scene& wished, const RestSize& size,
                                                       const std::optional<TriangleMesh>& obstacle,
                                                       std::string_view state, Settings settings) {
  if (auto narrow = check_width(wished, size.grid); !narrow) return tl::unexpected(narrow.error());
  const auto refused = [&wished](Error error) {
    error.place = wished.name;
    return tl::unexpected(std::move(error));
  };
  StateHead head{.grid = size.grid, .is_fastened = wished.fastening.has_value()};
  StateArchive beginning(state);
  visit_head(beginning, head);
  beginning.ignore_rest();
  if (auto read = beginning.finish(); !read) return refused(read.error());
  const Scene scene = with_single_rounding(wished, size, head.reach_m);
  const Matrix3Xd nowhere = Matrix3Xd::Zero(3, size.grid.particle_count());
  FasteningProcessor processor(scene, size, obstacle, all_vertices(nowhere, obstacle));
  if (auto few = check_substeps(scene, processor.deformation_.substeps()); !few)
    return tl::unexpected(few.error());
  if (scene.fastening) processor.hands_.emplace(scene, size, processor.cloth_);
  StateArchive archive(state);
  processor.visit_state(archive, settings);
  if (auto read = archive.finish(); !read) return refused(read.error());
  return processor;
}

std::string FasteningProcessor::state() {
  StateArchive archive;
  visit_state(archive, Settings::as_before);
  return archive.bytes();
}

void FasteningProcessor::visit_state(StateArchive& archive, Settings settings) {
  auto& [step_s, springs, steps, steps_before, before_s, cloth, bodies, deformation, hands, size,
         gaps, start, guaranteed_gap_m, reach_m] = *this;
  StateHead head{size.grid, hands.has_value(), step_s, reach_m};
  visit_head(archive, head);
  reach_m = head.reach_m;
  archive.visit(steps, 0, most_steps);
  archive.visit(steps_before, 0, steps);
  archive.visit(before_s);
  archive.visit(guaranteed_gap_m);
  visit_start(archive, start);
  cloth.visit_state(archive);
  bodies->visit_state(archive);
  if (hands) hands->visit_state(archive);
  if (settings == Settings::changed) {
    archive.ignore_rest();
    go_on_with_other_steps(head.step_s);
  } else {
    if (head.step_s != step_s) archive.refuse("it was made with another time.step");
    if (hands) hands->visit_memory(archive);
  }
}

// The clock of the scene that comes takes over from the one whose steps took step_s.
void FasteningProcessor::go_on_with_other_steps(double step_s) {
  if (step_s == step_s_) return;
  before_s_ += static_cast<double>(steps_ - steps_before_) * step_s;
  steps_before_ = steps_;
}

long FasteningProcessor::steps_at(double time_s) const {
  const double steps = (time_s - before_s_) / step_s_;
  return steps_before_ + static_cast<long>(std::ceil(steps - 1e-9 * (1 + steps)));
}

StepReport FasteningProcessor::step() {
  ++steps_;
  StageClock& clock = deformation_.clock();
  clock.charge(Stage::fastening);
  const Matrix3Xd force = hands_ ? hands_->pull(cloth_) : Matrix3Xd(3, 0);
  const PostStepReport report = deformation_.step(force, cloth_);
  clock.charge(Stage::fastening);
  if (hands_) hands_->follow(cloth_);
  clock.stop();
  return {.recovery_iterations = report.recovery_iterations,
          .penetrating_edges = report.penetrating_edges,
          .held_back = report.held_back,
          .pull = hands_ ? hands_->force_fraction() : 1};
}

std::optional<Tightness> FasteningProcessor::tightness() {
  if (!hands_) return std::nullopt;
  const ContactExtent contact = contact_extent(*bodies_, size_, gaps_, cloth_.positions);
  return Tightness{.progress = hands_->progress(),
                   .contact_share = contact.share,
                   .rope_length = contact.knotted_m / size_.width_m};
}

double FasteningProcessor::strain() const {
  return worst_strain(springs_, cloth_.positions);
}

Matrix3Xd FasteningProcessor::positions() const {
  return cloth_.positions.leftCols(cloth_.particle_count());
}

}  // namespace ribbon
