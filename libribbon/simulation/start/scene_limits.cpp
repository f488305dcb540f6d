#include "simulation/start/scene_limits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

#include "simulation/state/edge_strain.h"
#include "simulation/truncation/strain_constraints.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

bool is_lossless(const Scene& scene) {
  return scene.recording.max_position_error == 0;
}

// The largest coordinate; not a number where one is not.
double farthest_m(const Matrix3Xd& positions) {
  return positions.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

// The smallest that is no smaller than a number above 0.
double next_power_of_two(double number) {
  int exponent = 0;
  const double fraction = std::frexp(number, &exponent);  // from 1/2 on, below 1
  return std::isfinite(number) ? std::ldexp(1, fraction == 0.5 ? exponent - 1 : exponent) : number;
}

Result<void> arithmetic_keeps_the_gap(const Scene& scene, double gap_m, double farthest_m) {
  // Heights over a plane take some ten roundings.
  const double most_m = 1e-3 * gap_m / (16 * std::numeric_limits<double>::epsilon());
  if (farthest_m <= most_m) return {};  // false for NaN
  return failure(scene.name,
                 "a position lies " + metres(farthest_m) +
                     " from the origin, too far to tell gaps of " + metres(gap_m) + " apart",
                 "keep ribbon and obstacle within " + metres(0.99 * most_m) +
                     " of the origin, or make the edges of the ribbon longer");
}

Result<void> recording_tells_positions(const Scene& scene, const RestSize& size, double rounding_m,
                                       double farthest_m) {
  const double single_m = std::ldexp(farthest_m, -24);
  if (single_m <= rounding_m) return {};
  const double least = 1.01 * single_m / size.length_m;
  return failure(scene.name,
                 "the ribbon lies " + metres(farthest_m) +
                     " from the origin, where recorded coordinates are only right to " +
                     metres(single_m),
                 "move it to within " + metres(0.99 * std::ldexp(rounding_m, 24)) +
                     " of the origin with curve.origin" +
                     (least > most_position_error
                          ? " or make it smaller"
                          : ", make it smaller, or set recording.max_position_error to " +
                                short_number(least, 3) + " or more"));
}

// Which is more than what the gap asks for.
Result<void> recording_keeps_the_strain(const Scene& scene, const RestSize& size,
                                        const ContactLengths& lengths) {
  const double edge_m = size.shortest_edge_m();
  const double most_m = coarsest_rounding_m(edge_m, least_aimed_strain);
  if (lengths.rounding_m <= most_m) return {};
  const double least = 0.99 * most_m / size.length_m;
  std::string what = "recording";
  std::string remedy = "set fewer particles, or a shorter ribbon";
  if (is_lossless(scene)) {
    what += " in single precision";
    remedy = "move the ribbon to the origin with curve.origin, or set fewer particles";
  } else if (least > least_position_error) {
    remedy = "set recording.max_position_error to " + short_number(least, 3) +
             " or less, or fewer particles";
  }
  return failure(scene.name,
                 what + " may move coordinates by " + metres(lengths.rounding_m) +
                     ", too much to keep edges of " + metres(edge_m) + " within " +
                     short_number(100 * paper_strain_limit, 3) + " % of their rest length",
                 remedy);
}

// Of the ribbon's length. Cloth that may hardly be strained takes the correction several times as
// long, and is another cloth; above all along the ribbon, where hands that yield at the usual 5 %
// stretch it to that and beyond.
double usual_position_error(const Scene& scene, const RestSize& size) {
  constexpr double usual = 1e-5;
  constexpr double least_strain = 0.05;
  constexpr double least_strain_along = 0.07;
  if (scene.contact != ContactMethod::gate) return usual;
  const double borne_m = std::min(coarsest_rounding_m(size.shortest_edge_m(), least_strain),
                                  coarsest_rounding_m(size.along_m(), least_strain_along));
  return std::clamp(borne_m / size.length_m, least_position_error, usual);
}

}  // namespace

double recorded_reach_m(const Scene& scene, const RestSize& size, const Matrix3Xd& positions) {
  if (!is_lossless(scene)) return std::numeric_limits<double>::max();
  const double far_m = farthest_m(positions) + size.length_m;
  return next_power_of_two(2 * far_m);
}

Scene with_rounding(Scene scene, const RestSize& size, double reach_m) {
  std::optional<double>& error = scene.recording.max_position_error;
  // Half of the spacing of the numbers below the reach, a power of two.
  if (is_lossless(scene)) error = std::ldexp(reach_m, -25) / size.length_m;
  if (!error) error = usual_position_error(scene, size);
  return scene;
}

Result<void> check_precision(const Scene& as_read, const RestSize& size,
                             const ContactLengths& lengths, const Matrix3Xd& positions,
                             const std::optional<TriangleMesh>& obstacle) {
  const double ribbon_m = farthest_m(positions);
  const double obstacle_m = obstacle ? farthest_m(obstacle->vertices.cast<double>()) : 0;
  Result<void> kept = arithmetic_keeps_the_gap(
      as_read, lengths.min_separation_m,
      Eigen::Vector2d(ribbon_m, obstacle_m).maxCoeff<Eigen::PropagateNaN>());
  if (kept && !is_lossless(as_read))
    kept = recording_tells_positions(as_read, size, lengths.rounding_m, ribbon_m);
  if (!kept || as_read.contact != ContactMethod::gate) return kept;
  kept = recording_keeps_the_strain(as_read, size, lengths);
  assert(!kept || recorded_gap_m(lengths) > 0);
  return kept;
}

Result<void> check_fabric(const Scene& scene, const RestSize& size) {
  constexpr double most_edges = 3;
  const double edge_m = size.shortest_edge_m();
  const double thickness_m = scene.ribbon.thickness_m;
  if (!scene.cloth || !scene.cloth->tells_thickness || thickness_m <= most_edges * edge_m)
    return {};
  return failure(scene.cloth->place,
                 "'" + std::string(scene.cloth->fabric.name) + "' is " + metres(thickness_m) +
                     " thick, more than three times the " + metres(edge_m) +
                     " between its particles",
                 "set a smaller thickness of your own in [ribbon], or fewer particles");
}

Result<void> check_width(const Scene& scene, const RibbonGrid& grid) {
  if (scene.time.integrator != IntegrationMethod::implicit || grid.across <= most_across_implicit)
    return {};
  return failure(scene.name,
                 "the ribbon is " + std::to_string(grid.across) +
                     " particles wide, more than the " + std::to_string(most_across_implicit) +
                     " that time.integrator = \"implicit\" takes",
                 "set a smaller ribbon.across or another integrator");
}

Result<void> check_substeps(const Scene& scene, const SpringNetwork& springs,
                            const Integrator& integrator) {
  const int most = most_explicit_parts(integrator.method(), scene.contact, springs);
  if (integrator.method() == IntegrationMethod::implicit || integrator.substeps() <= most)
    return {};
  return failure(
      scene.name,
      "springs and air divide each step into " + std::to_string(integrator.substeps()) +
          " parts, more than " + std::to_string(most) +
          (scene.contact == ContactMethod::gate ? ""
           : integrator.method() == IntegrationMethod::rk4 && springs.bends_most()
               ? " that contact = \"paper\" takes where bending resists most"
               : " that contact = \"paper\" takes"),
      std::string("set smaller resistances, a larger ribbon.mass, a shorter time.step, ") +
          (scene.time.integrator
               ? "or time.integrator to \"implicit\""
               : "or a ribbon.across of at most " + std::to_string(most_across_implicit)));
}

}  // namespace ribbon
