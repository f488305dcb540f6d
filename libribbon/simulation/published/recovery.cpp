#include "simulation/published/recovery.h"

#include <vector>

#include "simulation/published/penetration.h"
#include "simulation/published/recovery_schemes.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

// What Figure 15 calls by name: the three tests, and the scheme that answers to each.
class Recovery {
 public:
  using Penetrations = std::vector<Penetration>;

  Recovery(Bodies& bodies, const RecoverySettings& settings, Matrix3Xd& positions)
      : bodies_(bodies), settings_(settings), positions_(positions) {}

  Penetrations ribbon_into_obstacle() {
    if (!bodies_.obstacle) return {};
    return mutual_penetrations(bodies_.ribbon.surface(), bodies_.ribbon.triangle_bvh(positions_),
                               *bodies_.obstacle, positions_)
        .edges_of_ribbon;
  }
  void scheme_a(const Penetrations& found) {
    apply_scheme_a(bodies_.grid, bodies_.ribbon.surface(), *bodies_.obstacle, found,
                   settings_.gap_m, positions_);
  }

  Penetrations border_into_ribbon() {
    Penetrations found = ribbon_into_itself();
    std::erase_if(found, [&](const Penetration& penetration) {
      return !is_border_edge(bodies_.grid, bodies_.ribbon.surface().edges[penetration.edge]);
    });
    return found;
  }
  void scheme_b(const Penetrations& found) {
    apply_scheme_b(bodies_.grid, bodies_.ribbon.surface(), found, settings_.step_m, positions_);
  }

  Penetrations ribbon_into_itself() {
    return self_penetrations(bodies_.ribbon.surface(), bodies_.ribbon.triangle_bvh(positions_),
                             TriangleBvh::Spare::curvature_and_boxes, positions_);
  }
  void scheme_c(const Penetrations& found) {
    apply_scheme_c(bodies_.grid, bodies_.ribbon.surface(), found, settings_.gap_m, positions_);
  }

  // while (∃ error) apply the scheme, until `patience` applications in a row have left no fewer
  // penetrations than there were at best; those are taken back.
  void apply_while_any(Penetrations (Recovery::*test)(),
                       void (Recovery::*scheme)(const Penetrations&)) {
    Penetrations found = (this->*test)();
    std::size_t fewest = found.size();
    Matrix3Xd best = positions_;
    int in_vain = 0;
    while (!found.empty() && in_vain < settings_.patience) {
      (this->*scheme)(found);
      ++iterations_;
      found = (this->*test)();
      if (found.size() < fewest) {
        fewest = found.size();
        best = positions_;
        in_vain = 0;
      } else {
        ++in_vain;
      }
    }
    if (in_vain > 0) positions_ = best;
  }

  // All applications of a scheme so far.
  [[nodiscard]] int iterations() const { return iterations_; }

 private:
  Bodies& bodies_;
  const RecoverySettings& settings_;
  Matrix3Xd& positions_;
  int iterations_ = 0;
};

}  // namespace

int count_penetrating_edges(Bodies& bodies, const Matrix3Xd& positions) {
  // An honest count does not lean on curvature.
  std::vector<Penetration> of_ribbon =
      self_penetrations(bodies.ribbon.surface(), bodies.ribbon.triangle_bvh(positions),
                        TriangleBvh::Spare::boxes, positions);
  int of_obstacle = 0;
  if (bodies.obstacle) {
    const MutualPenetrations mutual =
        mutual_penetrations(bodies.ribbon.surface(), bodies.ribbon.triangle_bvh(positions),
                            *bodies.obstacle, positions);
    of_ribbon.insert(of_ribbon.end(), mutual.edges_of_ribbon.begin(), mutual.edges_of_ribbon.end());
    of_obstacle = distinct_edges(mutual.edges_of_obstacle);
  }
  return distinct_edges(of_ribbon) + of_obstacle;
}

// Figure 15.
RecoveryReport recover(Bodies& bodies, const RecoverySettings& settings, Matrix3Xd& positions) {
  Recovery recovery(bodies, settings, positions);
  int penetrating = count_penetrating_edges(bodies, positions);
  bool improves = true;
  while (penetrating > 0 && improves) {
    const Matrix3Xd before = positions;
    recovery.apply_while_any(&Recovery::ribbon_into_obstacle, &Recovery::scheme_a);
    recovery.apply_while_any(&Recovery::border_into_ribbon, &Recovery::scheme_b);
    recovery.apply_while_any(&Recovery::ribbon_into_itself, &Recovery::scheme_c);
    const int left = count_penetrating_edges(bodies, positions);
    improves = left < penetrating;
    if (improves)
      penetrating = left;
    else
      positions = before;  // moving out of the obstacle may cost more than it brings
  }
  return {.iterations = recovery.iterations(), .penetrating_edges = penetrating};
}

}  // namespace ribbon
