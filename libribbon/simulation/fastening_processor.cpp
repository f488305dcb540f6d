#include "simulation/fastening_processor.h"

#include <utility>

#include "simulation/band_edges.h"
#include "simulation/contact_extent.h"
#include "simulation/gap_lengths.h"
#include "simulation/scene_limits.h"
#include "simulation/width_growth.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr int settling_rounds = 50;  // at most, before the first step

// Particles first, the obstacle's vertices behind them.
Matrix3Xd all_vertices(const RibbonMesh& ribbon, const std::optional<TriangleMesh>& obstacle) {
  const Eigen::Index particles = ribbon.positions.cols();
  Matrix3Xd all(3, particles + (obstacle ? obstacle->vertices.cols() : 0));
  all.leftCols(particles) = ribbon.positions;
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

}  // namespace

FasteningProcessor::FasteningProcessor(const Scene& scene, const RibbonMesh& ribbon,
                                       const std::optional<TriangleMesh>& obstacle,
                                       Matrix3Xd vertices)
    : step_s_(scene.time.step_s),
      springs_(scene.springs),
      cloth_{std::move(vertices), Matrix3Xd::Zero(3, ribbon.positions.cols()),
             scene.ribbon.mass_kg / ribbon.grid.particle_count()},
      bodies_(bodies_of(ribbon.grid, obstacle, cloth_.positions)),
      deformation_(scene, natural_size(ribbon, 1), cloth_.particle_mass_kg, *bodies_),
      size_(natural_size(ribbon, 1)),
      gaps_(size_, gap_lengths(size_.shortest_edge_m(),
                               scene.recording.max_position_error_m(ribbon.length_m),
                               scene.ribbon.thickness_m)) {}

Result<FasteningProcessor> FasteningProcessor::create(const Scene& scene, const RibbonMesh& ribbon,
                                                      const std::optional<TriangleMesh>& obstacle) {
  Matrix3Xd vertices = all_vertices(ribbon, obstacle);
  const auto precise = check_precision(scene, natural_size(ribbon, 1), vertices);
  if (!precise) return tl::unexpected(precise.error());
  const auto narrow = check_width(scene, ribbon.grid);
  if (!narrow) return tl::unexpected(narrow.error());
  FasteningProcessor processor(scene, ribbon, obstacle, std::move(vertices));
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
  if (scene.fastening) hands_.emplace(scene, ribbon.grid, ribbon.length_m, cloth_);
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
          .pull = hands_ ? hands_->share() : 1};
}

std::optional<Tightness> FasteningProcessor::tightness() {
  if (!hands_) return std::nullopt;
  const ContactExtent contact = contact_extent(*bodies_, size_, gaps_, cloth_.positions);
  return Tightness{.progress = hands_->progress(),
                   .contact_share = contact.share,
                   .rope_length = contact.knotted_m / size_.width_m};
}

double FasteningProcessor::strain() const {
  return worst_strain(size_, springs_, cloth_.positions);
}

Matrix3Xd FasteningProcessor::positions() const {
  return cloth_.positions.leftCols(cloth_.particle_count());
}

}  // namespace ribbon
