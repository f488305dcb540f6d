#include "simulation/start/scene_limits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

#include "geometry/single_precision.h"
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

// What a recorded coordinate may be off by, and what else bounds that.
struct CoordinateError {
  double asked_m;     // by the scene
  double borne_m;     // at most, by the edges
  double length_m;    // of the ribbon
  double farthest_m;  // the same's largest coordinate
  double obstacle_m;  // the obstacle's; 0 where there is none

  // What single precision takes at that distance.
  [[nodiscard]] double single_m() const { return largest_rounding(farthest_m); }
  // Is there an error that a scene may ask for, finer than edges bear and no finer than that? With
  // room for the digits in which it is told.
  [[nodiscard]] bool can_serve() const {
    return 1.01 * least_m() <= 0.99 * std::min(borne_m, most_position_error * length_m);
  }
  [[nodiscard]] double least_m() const {
    return std::max(single_m(), least_position_error * length_m);
  }
};

// To where single precision takes less than that.
std::string move_nearer(const CoordinateError& error, double rounding_m) {
  const double within_m = 0.99 * rounding_m / largest_rounding(1);
  return "move it to within " + metres(within_m) + " of the origin with curve.origin" +
         (error.obstacle_m > within_m ? " and obstacle.position" : "");
}

// Nothing where no error serves.
std::string set_error(const CoordinateError& error) {
  if (!error.can_serve()) return "";
  return ", or set recording.max_position_error to " +
         short_number(1.01 * error.least_m() / error.length_m, 3) + " or more";
}

Result<void> recording_tells_positions(const Scene& scene, const CoordinateError& error) {
  const double single_m = error.single_m();
  if (single_m <= error.asked_m) return {};
  return failure(scene.name,
                 "the ribbon lies " + metres(error.farthest_m) +
                     " from the origin, where recorded coordinates are only right to " +
                     metres(single_m),
                 move_nearer(error, std::min(error.asked_m, error.borne_m)) + set_error(error));
}

// Which is more than what the gap asks for.
Result<void> recording_keeps_the_strain(const Scene& scene, const RestSize& size,
                                        const CoordinateError& error) {
  const double most_m = error.borne_m;
  if (error.asked_m <= most_m) return {};
  const double least = 0.99 * most_m / size.length_m;
  std::string what = "recording";
  std::string remedy = "set fewer particles, or a shorter ribbon";
  if (is_lossless(scene)) {
    what += " in single precision";
    remedy = "set fewer particles, or move the ribbon to the origin with curve.origin" +
             set_error(error);
  } else if (least > least_position_error) {
    remedy = "set recording.max_position_error to " + short_number(least, 3) + " or less";
    // So fine it may be nearer only.
    if (!error.can_serve()) remedy += " and " + move_nearer(error, 0.98 * most_m);
    remedy += ", or fewer particles";
  }
  return failure(scene.name,
                 what + " may move coordinates by " + metres(error.asked_m) +
                     ", too much to keep edges of " + metres(size.shortest_edge_m()) + " within " +
                     short_number(100 * paper_strain_limit, 3) + " % of their rest length",
                 remedy);
}

// As of a drawing that was taken for metres, or a width for millimetres, which no recording holds
// even at the origin: that tells more than what is too coarse because of it.
bool is_no_ribbon(const RestSize& size, CoordinateError error) {
  constexpr double most_widths_long = 1e4;
  constexpr double most_lengths_wide = 10;
  error.farthest_m = std::min(error.farthest_m, size.length_m + size.width_m);
  return !error.can_serve() && (size.length_m > most_widths_long * size.width_m ||
                                size.width_m > most_lengths_wide * size.length_m);
}

tl::unexpected<Error> refused_size(const Scene& scene, const RestSize& size) {
  return failure(scene.name,
                 "the ribbon is " + metres(size.length_m) + " long and " + metres(size.width_m) +
                     " wide, and no recording holds edges of so different lengths",
                 "set curve.unit, now " + shortest(scene.curve.unit_m) +
                     " m, or ribbon.width so that they fit each other");
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
  // The reach is a power of two, so that the numbers below it are as finely spaced as its half.
  if (is_lossless(scene)) error = largest_rounding(0.5 * reach_m) / size.length_m;
  if (!error) error = usual_position_error(scene, size);
  return scene;
}

Result<void> check_precision(const Scene& as_read, const RestSize& size,
                             const ContactLengths& lengths, const Matrix3Xd& positions,
                             const std::optional<TriangleMesh>& obstacle) {
  const bool has_gate = as_read.contact == ContactMethod::gate;
  const CoordinateError error = {
      .asked_m = lengths.rounding_m,
      .borne_m = has_gate ? coarsest_rounding_m(size.shortest_edge_m(), least_aimed_strain)
                          : std::numeric_limits<double>::infinity(),
      .length_m = size.length_m,
      .farthest_m = farthest_m(positions),
      .obstacle_m = obstacle ? farthest_m(obstacle->vertices.cast<double>()) : 0};
  Result<void> kept = arithmetic_keeps_the_gap(
      as_read, lengths.min_separation_m,
      Eigen::Vector2d(error.farthest_m, error.obstacle_m).maxCoeff<Eigen::PropagateNaN>());
  if (kept && !is_lossless(as_read)) kept = recording_tells_positions(as_read, error);
  if (kept && has_gate) kept = recording_keeps_the_strain(as_read, size, error);
  if (!kept && is_no_ribbon(size, error)) return refused_size(as_read, size);
  assert(!kept || !has_gate || recorded_gap_m(lengths) > 0);
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
