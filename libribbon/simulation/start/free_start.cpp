#include "simulation/start/free_start.h"

#include <cassert>
#include <optional>
#include <string>

#include "simulation/contact/gap_lengths.h"
#include "simulation/published/recovery.h"
#include "simulation/start/encounter.h"
#include "simulation/start/width_growth.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr int thinnest = 64;            // part of the width
constexpr double gap_per_edge = 0.025;  // half of what the gate keeps at least
constexpr int parting_steps = 60;       // at most, until nothing is too close
constexpr int patience = 30;            // scheme A leads out of an obstacle layer by layer

// The search for a free start of one ribbon.
class StartSearch {
 public:
  StartSearch(const Scene& scene, const RibbonMesh& ribbon, Bodies& bodies,
              Deformation& deformation, Cloth& cloth)
      : scene_(scene),
        ribbon_(ribbon),
        bodies_(bodies),
        deformation_(deformation),
        cloth_(cloth),
        generated_(cloth.positions) {}

  Result<StartReport> find() {
    if (is_free() && settles()) return report_;
    if (!take_thin_band() && !take_recovered_band()) return pierced();
    const GrowthReport growth = grow_width(scene_, ribbon_, share_, bodies_, cloth_);
    if (!growth.complete) return no_room(growth);
    if (!settles()) return too_close();
    return report_;
  }

 private:
  // The band as generated, at a share of its width.
  void take_band(double share) {
    share_ = share;
    cloth_.positions = rows_scaled(ribbon_.grid, share, generated_);
  }

  [[nodiscard]] double shortest_edge_m() const {
    return rest_size(ribbon_, share_).shortest_edge_m();
  }

  std::optional<Encounter> encounter() {
    if (const auto piercing = first_piercing(bodies_, cloth_.positions)) return piercing;
    return first_closer_than(gap_per_edge * shortest_edge_m(), bodies_, cloth_.positions);
  }

  bool is_free() { return cloth_.positions.allFinite() && !encounter(); }

  // Settles the band at its whole width; is it then as far from everything as the gate wants it?
  bool settles() {
    share_ = 1;
    deformation_.settle(settling_rounds, cloth_);
    for (int step = 0; step < parting_steps && is_too_close(); ++step) {
      deformation_.step({3, 0}, cloth_);
      cloth_.velocities.setZero();
    }
    return !is_too_close() && is_free();
  }

  [[nodiscard]] double hard_gap_m() const {
    const double rounding_m = scene_.recording.max_position_error_m(ribbon_.length_m);
    return gap_lengths(shortest_edge_m(), rounding_m, 0).hard_m;
  }

  bool is_too_close() {
    return first_closer_than((1 - 1e-9) * hard_gap_m(), bodies_, cloth_.positions).has_value();
  }

  bool take_thin_band() {
    report_.kind = StartKind::grown;
    for (int part = 2; part <= thinnest; part *= 2) {
      take_band(1.0 / part);
      if (is_free()) return true;
    }
    return false;
  }

  // The schemes lead out of obstacles; where the thinnest band meets itself they have little to
  // try.
  bool take_recovered_band() {
    report_.kind = StartKind::recovered;
    take_band(1.0 / thinnest);
    const auto at = encounter();
    for (int part = at && of_obstacle(*at) ? 1 : thinnest; part <= thinnest; part *= 2) {
      take_band(1.0 / part);
      const RecoverySettings settings{.gap_m = 0.1 * shortest_edge_m(),
                                      .step_m = 0.5 * shortest_edge_m(),
                                      .patience = patience};
      report_.recovery_iterations += recover(bodies_, settings, cloth_.positions).iterations;
      if (is_free()) return true;
    }
    return false;
  }

  // ---- What to say where there is no free start

  [[nodiscard]] std::string place_of(int particle) const {
    const int row = ribbon_.grid.row(particle);
    return "row " + std::to_string(row + 1) + " of " + std::to_string(ribbon_.grid.along) + ", " +
           metres(row * rest_size(ribbon_, 1).along_m()) + " from its first end";
  }

  [[nodiscard]] bool of_obstacle(const Encounter& encounter) const {
    return encounter.other >= ribbon_.grid.particle_count();
  }

  tl::unexpected<Error> pierced() {
    take_band(1.0 / thinnest);
    const std::optional<Encounter> at = encounter();
    assert(at);  // it was found before
    return failure(
        scene_.name,
        "even a thin band along the drawing meets " +
            (of_obstacle(*at)
                 ? "the obstacle at " + place_of(at->particle)
                 : "itself at " + place_of(at->particle) + ", and " + place_of(at->other)),
        (of_obstacle(*at) ? "" : "set a smaller ribbon.width, or ") + remedy(of_obstacle(*at)));
  }

  tl::unexpected<Error> too_close() {
    const auto at = first_closer_than((1 - 1e-9) * hard_gap_m(), bodies_, cloth_.positions);
    return failure(scene_.name,
                   "the ribbon does not come clear of " +
                       std::string(at && of_obstacle(*at) ? "the obstacle" : "itself") +
                       (at ? " at " + place_of(at->particle) : ""),
                   remedy(at && of_obstacle(*at)));
  }

  tl::unexpected<Error> no_room(const GrowthReport& growth) {
    const std::string at = ", strained most at " + place_of(growth.strained_particle);
    if (growth.settled_share == 0)
      return failure(scene_.name,
                     report_.kind == StartKind::recovered
                         ? "moved out of what it pierced, the ribbon does not settle" + at
                         : "even a thin band along the drawing does not settle" + at,
                     remedy(report_.kind == StartKind::recovered));
    const double roomy_m = growth.settled_share * ribbon_.width_m;
    return failure(scene_.name,
                   "the ribbon finds no room for its width of " + metres(ribbon_.width_m) +
                       ": grown from a thin band it settles up to " + metres(roomy_m) + " only" +
                       at,
                   // With a margin: grown in other steps, it folds otherwise.
                   "set ribbon.width to " + short_number(0.9 * roomy_m, 3) +
                       ", or leave more room there, between the strands" +
                       (bodies_.obstacle ? " and around the obstacle" : " of the drawing"));
  }

  static std::string remedy(bool of_obstacle) {
    return of_obstacle ? "draw the ribbon around the obstacle, move the obstacle with "
                         "obstacle.position or make it smaller with obstacle.scale"
                       : "draw the strands further apart there";
  }

  const Scene& scene_;
  const RibbonMesh& ribbon_;
  Bodies& bodies_;
  Deformation& deformation_;
  Cloth& cloth_;
  Matrix3Xd generated_;
  double share_ = 1;  // of its width that the band has now
  StartReport report_;
};

}  // namespace

std::string_view word_for(StartKind kind) {
  switch (kind) {
    case StartKind::free:
      return "free";
    case StartKind::grown:
      return "grown";
    case StartKind::recovered:
      return "recovered";
  }
  return "";
}

Result<StartReport> find_free_start(const Scene& scene, const RibbonMesh& ribbon, Bodies& bodies,
                                    Deformation& deformation, Cloth& cloth) {
  Result<StartReport> start = StartSearch(scene, ribbon, bodies, deformation, cloth).find();
  bodies.ribbon.forget();
  return start;
}

}  // namespace ribbon
