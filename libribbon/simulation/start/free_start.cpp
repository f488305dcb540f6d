#include "simulation/start/free_start.h"

#include <cassert>
#include <optional>
#include <string>

#include "simulation/published/recovery.h"
#include "simulation/start/dynamic_relaxation.h"
#include "simulation/start/first_intersection.h"
#include "simulation/start/width_growth.h"
#include "simulation/state/edge_strain.h"
#include "simulation/step/gated_step.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr int thinnest = 64;                   // part of the width
constexpr double separation_per_edge = 0.025;  // half of the smallest minimum separation
constexpr int parting_steps = 60;              // at most, until nothing is too close
constexpr int patience = 30;                   // scheme A leads out of an obstacle layer by layer

// The search for a free start of one ribbon.
class StartSearch {
 public:
  StartSearch(const Scene& scene, const RibbonMesh& ribbon, const ContactLengths& lengths,
              const StartObserver& observer, const StartTest& test, Bodies& bodies, Cloth& cloth)
      : scene_(scene),
        ribbon_(ribbon),
        lengths_(lengths),
        observer_(observer),
        test_(test),
        too_close_m_((1 - 1e-9) * lengths.min_separation_m),
        bodies_(bodies),
        step_(scene, ribbon.size(), lengths, cloth.particle_mass_kg),
        cloth_(cloth),
        generated_(cloth.positions) {}

  Result<StartReport> find() {
    Result<StartReport> start = search();
    if (is_given_up_) return given_up();
    return start;
  }

 private:
  Result<StartReport> search() {
    if (is_free() && settles()) return relaxed();
    if (!take_thin_band() && !take_recovered_band()) return pierced();
    const GrowthReport growth = grow_width(
        scene_, ribbon_, fraction_, [this](const auto& what) { return goes_on(what); }, bodies_,
        cloth_);
    if (!growth.complete) return no_room(growth);
    if (!settles()) return is_too_close() ? too_close() : strained();
    return relaxed();
  }

  // Tells the observer; false once that has given the search up.
  bool goes_on(const std::string& what) {
    is_given_up_ = is_given_up_ || (observer_ && !observer_(what));
    return !is_given_up_;
  }

  // The band as generated, at a fraction of its width.
  void take_band(double fraction) {
    fraction_ = fraction;
    cloth_.positions = rows_scaled(ribbon_.grid, fraction, generated_);
  }

  [[nodiscard]] double shortest_edge_m() const {
    return ribbon_.size().narrowed(fraction_).shortest_edge_m();
  }

  std::optional<MeetingPlace> meeting_place() {
    if (const auto piercing = first_intersection(bodies_, cloth_.positions)) return piercing;
    return first_closer_than(separation_per_edge * shortest_edge_m(), bodies_, cloth_.positions);
  }

  bool is_free() { return cloth_.positions.allFinite() && !meeting_place(); }

  // Settles the band at its whole width; are its minimum separation and its strain kept then?
  bool settles() {
    const std::string what = "the ribbon settles at its whole width";
    if (!goes_on(what)) return false;
    fraction_ = 1;
    step_.settle(settling_rounds, bodies_, cloth_);
    for (int step = 0; step < parting_steps && (is_too_close() || is_strained()); ++step) {
      if (!goes_on(what)) return false;
      step_.advance_under(Matrix3Xd(3, 0), bodies_, cloth_);
      cloth_.velocities.setZero();
    }
    return !is_too_close() && !is_strained() && is_free();
  }

  StartReport relaxed() {
    const Matrix3Xd strained = cloth_.positions;
    if (!goes_on("the ribbon lets go of what bending it has strained")) return report_;
    const int steps = relax(scene_, ribbon_.size(), lengths_, bodies_, cloth_);
    if (steps > 0 && test_ && !test_(cloth_.positions)) cloth_.positions = strained;
    return report_;
  }

  bool is_too_close() {
    return first_closer_than(too_close_m_, bodies_, cloth_.positions).has_value();
  }

  bool is_strained() { return !step_.is_bearable(cloth_); }

  bool take_thin_band() {
    report_.kind = StartKind::grown;
    for (int part = 2; part <= thinnest && !is_given_up_; part *= 2) {
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
    pierced_ = meeting_place();
    for (int part = pierced_ && of_obstacle(*pierced_) ? 1 : thinnest; part <= thinnest;
         part *= 2) {
      take_band(1.0 / part);
      const std::string width =
          part == 1 ? "at its whole width" : "at 1/" + std::to_string(part) + " of its width";
      if (!goes_on("the ribbon is moved out of what it pierces, " + width)) return false;
      RecoverySettings settings = RecoverySettings::of_edge(shortest_edge_m());
      settings.patience = patience;
      report_.recovery_iterations += recover(bodies_, settings, cloth_.positions).iterations;
      if (is_free()) return true;
    }
    return false;
  }

  // ---- What to say where there is no free start

  [[nodiscard]] std::string place_of(int particle) const {
    const int row = ribbon_.grid.row(particle);
    return "row " + std::to_string(row + 1) + " of " + std::to_string(ribbon_.grid.along) + ", " +
           metres(row * ribbon_.size().along_m()) + " from its first end";
  }

  [[nodiscard]] bool of_obstacle(const MeetingPlace& place) const {
    return !bodies_.is_particle(place.other);
  }

  // The strands have no room: where the drawing is tightest, if it had to be squeezed.
  [[nodiscard]] std::string tight_passage() const {
    const auto& tight = ribbon_.squeezed;
    return tight ? " (" + tight->place + ": " + tight->problem + ")" : "";
  }

  // Of the thinnest band, which was seen to be pierced.
  [[nodiscard]] std::string what_is_pierced() const {
    assert(pierced_);
    return "even a thin band along the drawing meets " +
           (of_obstacle(*pierced_) ? "the obstacle at " + place_of(pierced_->particle)
                                   : "itself at " + place_of(pierced_->particle) + ", and " +
                                         place_of(pierced_->other) + tight_passage());
  }
  [[nodiscard]] std::string remedy_for_what_is_pierced() const {
    return (of_obstacle(*pierced_) ? "" : "set a smaller ribbon.width, or ") +
           remedy(of_obstacle(*pierced_));
  }

  tl::unexpected<Error> given_up() {
    return passing_failure(scene_.name, "was interrupted while its start was looked for",
                           "run it again");
  }

  tl::unexpected<Error> pierced() {
    return failure(scene_.name, what_is_pierced(), remedy_for_what_is_pierced());
  }

  tl::unexpected<Error> too_close() {
    const auto at = first_closer_than(too_close_m_, bodies_, cloth_.positions);
    const bool from_obstacle = at && of_obstacle(*at);
    return failure(scene_.name,
                   "the ribbon does not come clear of " +
                       std::string(from_obstacle ? "the obstacle" : "itself") +
                       (at ? " at " + place_of(at->particle) : "") +
                       (from_obstacle ? "" : tight_passage()),
                   remedy(from_obstacle));
  }

  tl::unexpected<Error> strained() {
    return failure(scene_.name,
                   "the ribbon does not settle to within " +
                       short_number(100 * paper_strain_limit, 3) + " % of its rest lengths" +
                       tight_passage(),
                   "set a smaller ribbon.width, or leave more room between the strands");
  }

  tl::unexpected<Error> no_room(const GrowthReport& growth) {
    if (pierced_)
      return failure(scene_.name, what_is_pierced() + "; moved out of it, it does not settle",
                     remedy_for_what_is_pierced());
    const std::string at =
        ", strained most at " + place_of(growth.strained_particle) + tight_passage();
    if (growth.settled_fraction == 0)
      return failure(scene_.name, "even a thin band along the drawing does not settle" + at,
                     remedy(false));
    const double width_m = ribbon_.size().widest_m();
    const double roomy_m = growth.settled_fraction * width_m;
    return failure(
        scene_.name,
        "the ribbon finds no room for its width of " + metres(width_m) +
            ": grown from a thin band it settles up to " + metres(roomy_m) + " only" + at,
        // With a margin: grown in other steps, it folds otherwise.
        "set ribbon.width to " + std::string(ribbon_.size().has_profile() ? "at most " : "") +
            short_number(0.9 * roomy_m, 3) + ", or leave more room there, between the strands" +
            (bodies_.obstacle ? " and around the obstacle" : " of the drawing"));
  }

  static std::string remedy(bool of_obstacle) {
    return of_obstacle ? "draw the ribbon around the obstacle, tell by F and B in curve.crossings "
                         "where it lies in front of it and behind, move the obstacle with "
                         "obstacle.position or make it smaller with obstacle.scale"
                       : "draw the strands further apart there";
  }

  const Scene& scene_;
  const RibbonMesh& ribbon_;
  const ContactLengths& lengths_;
  const StartObserver& observer_;
  const StartTest& test_;
  double too_close_m_;
  Bodies& bodies_;
  GatedStep step_;
  Cloth& cloth_;
  Matrix3Xd generated_;
  double fraction_ = 1;                  // of its width, that the band has now
  std::optional<MeetingPlace> pierced_;  // by the thinnest band, where it was moved out
  StartReport report_;
  bool is_given_up_ = false;
};

}  // namespace

Result<StartReport> find_free_start(const Scene& scene, const RibbonMesh& ribbon,
                                    const ContactLengths& lengths, const StartObserver& observer,
                                    const StartTest& test, Bodies& bodies, Cloth& cloth) {
  // It begins to fall with its first step.
  Scene weightless = scene;
  weightless.gravity_m_s2.reset();
  Result<StartReport> start =
      StartSearch(weightless, ribbon, lengths, observer, test, bodies, cloth).find();
  bodies.ribbon.forget();
  return start;
}

}  // namespace ribbon
