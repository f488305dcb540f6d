#include "inspection/outcome.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "geometry/box.h"
#include "geometry/closest_points.h"
#include "geometry/row_middles.h"
#include "knot/motion/ribbon_curves.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// A full turn but for what two strands that cross are apart.
constexpr double full_turn = 0.97 * 2 * std::numbers::pi;

// Sums along a curve, from its first point to each.
struct TurnSums {
  double angle = 0;  // about the axis
  // Of the angle over the distance from the axis, and of that times the height: between the ends of
  // a full turn of a flat curve, their ratio is the height at which its plane meets the axis.
  double weight = 0;
  double weighted_height = 0;
};

std::vector<TurnSums> turn_sums(const ObjectAxis& axis, const Eigen::Matrix3Xd& curve) {
  const Eigen::Vector3d& along = axis.line.direction;
  const Eigen::Matrix3Xd from_point = curve.colwise() - axis.line.point_m;
  const Eigen::RowVectorXd heights = along.transpose() * from_point;
  const Eigen::Matrix3Xd from_axis = from_point - along * heights;
  std::vector<TurnSums> sums(1);
  for (Eigen::Index k = 0; k + 1 < curve.cols(); ++k) {
    const Eigen::Vector3d here = from_axis.col(k);
    const Eigen::Vector3d there = from_axis.col(k + 1);
    const double angle = std::atan2(along.dot(here.cross(there)), here.dot(there));
    const double radius_m = std::max((here + there).norm() / 2, std::numeric_limits<double>::min());
    TurnSums sum = sums.back();
    sum.angle += angle;
    sum.weight += angle / radius_m;
    sum.weighted_height += angle / radius_m * (heights[k] + heights[k + 1]) / 2;
    sums.push_back(sum);
  }
  return sums;
}

// How near the middle of each row comes to that of another which is at least two widths along the
// ribbon away.
Eigen::ArrayXd nearest_other_strand_m(const Eigen::Matrix3Xd& middles, double spacing_m,
                                      double width_m) {
  const auto count = static_cast<double>(middles.cols());
  const auto apart = static_cast<Eigen::Index>(std::ceil(std::min(2 * width_m / spacing_m, count)));
  Eigen::ArrayXd squared =
      Eigen::ArrayXd::Constant(middles.cols(), std::numeric_limits<double>::infinity());
  for (Eigen::Index i = 0; i < middles.cols(); ++i)
    for (Eigen::Index j = i + apart; j < middles.cols(); ++j) {
      const double squared_distance = (middles.col(i) - middles.col(j)).squaredNorm();
      squared[i] = std::min(squared[i], squared_distance);
      squared[j] = std::min(squared[j], squared_distance);
    }
  return squared.sqrt();
}

// The particles of the rows that come about as near to other parts of the ribbon as any does.
Eigen::Matrix3Xd knotted_particles(const RecordingHeader& header,
                                   const Eigen::Matrix3Xd& positions) {
  const RibbonGrid& grid = header.grid;
  const Eigen::Matrix3Xd middles = row_middles(grid, positions);
  const double spacing_m = header.ribbon_length_m / (grid.along - 1);
  const Eigen::ArrayXd nearest_m =
      nearest_other_strand_m(middles, spacing_m, header.ribbon_width_m);
  const double smallest_m = nearest_m.minCoeff();
  if (!(smallest_m < header.ribbon_width_m / 2)) return {};
  std::vector<int> particles;
  for (int p = 0; p < grid.particle_count(); ++p)
    if (nearest_m[grid.row(p)] <= 2 * smallest_m + spacing_m) particles.push_back(p);
  return positions(Eigen::all, particles);
}

double squared_distance(const Box& a, const Box& b) {
  return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0).squaredNorm();
}

double distance_m(const Eigen::Matrix3Xd& points, const TriangleMesh& object) {
  const Box around_points{points.rowwise().minCoeff(), points.rowwise().maxCoeff()};
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& triangle : object.triangles.colwise()) {
    const Eigen::Matrix3d corners = object.vertices(Eigen::all, triangle).cast<double>();
    const Box box{corners.rowwise().minCoeff(), corners.rowwise().maxCoeff()};
    if (squared_distance(around_points, box) >= nearest) continue;
    for (const auto& point : points.colwise()) {
      const Eigen::Vector3d weights =
          closest_on_triangle(point, corners.col(0), corners.col(1), corners.col(2));
      nearest = std::min(nearest, (corners * weights - point).squaredNorm());
    }
  }
  return std::sqrt(nearest);
}

// The frames of a recording that can be read.
class Frames {
 public:
  explicit Frames(RecordingReader& reader) : reader_(reader) {
    for (int index = 0; index < reader.frame_count(); ++index)
      if (reader.readable(index) && reader.numbers(index)) frames_.push_back(index);
  }

  [[nodiscard]] int count() const { return static_cast<int>(frames_.size()); }
  // Nothing where the frame turns out to be damaged.
  std::optional<Eigen::Matrix3Xf> operator[](int k) {
    Eigen::Matrix3Xf positions;
    if (!reader_.read(frames_[k], positions) || !positions.allFinite()) return std::nullopt;
    return positions;
  }
  [[nodiscard]] Outcome::Moment moment(int k) const {
    return {frames_[k] + 1, reader_.numbers(frames_[k])->time_s};
  }

 private:
  RecordingReader& reader_;
  std::vector<int> frames_;
};

// Of a ribbon that does not embrace the object in the last frame.
std::optional<Outcome::Moment> slipping_off(const RibbonGrid& grid, const ObjectAxis& axis,
                                            Frames& frames) {
  int round = 0;
  int off = frames.count() - 1;
  const auto is_round = [&](int k) {
    const auto positions = frames[k];
    return positions && embraces(axis, centre_line(grid, *positions));
  };
  if (!is_round(round)) return std::nullopt;
  while (off - round > 1) {
    const int middle = (round + off) / 2;
    (is_round(middle) ? round : off) = middle;
  }
  return frames.moment(off);
}

}  // namespace

bool embraces(const ObjectAxis& axis, const Eigen::Matrix3Xd& curve) {
  const std::vector<TurnSums> sums = turn_sums(axis, curve);
  const auto [low_m, high_m] = axis.extent();
  for (auto start = sums.begin(); start != sums.end(); ++start) {
    const auto end = std::find_if(start, sums.end(), [&](const TurnSums& sum) {
      return std::abs(sum.angle - start->angle) >= full_turn;
    });
    if (end == sums.end()) continue;
    const double height_m =
        (end->weighted_height - start->weighted_height) / (end->weight - start->weight);
    if (low_m < height_m && height_m < high_m) return true;
  }
  return false;
}

std::optional<double> knot_distance_m(const RecordingHeader& header,
                                      const Eigen::Matrix3Xf& positions,
                                      const TriangleMesh& object) {
  const Eigen::Matrix3Xd knot = knotted_particles(header, positions.cast<double>());
  if (knot.cols() == 0) return std::nullopt;
  return distance_m(knot, object);
}

std::optional<Outcome> outcome(RecordingReader& reader) {
  const RecordingHeader& header = reader.header();
  const auto axis = object_axis(header.centre_axis, header.obstacle);
  Frames frames(reader);
  if (!axis || frames.count() == 0) return std::nullopt;
  const auto last = frames[frames.count() - 1];
  if (!last) return std::nullopt;
  Outcome result;
  result.embraces_object = embraces(*axis, centre_line(header.grid, *last));
  if (!result.embraces_object) result.slipped_off = slipping_off(header.grid, *axis, frames);
  result.knot_distance_m = knot_distance_m(header, *last, *header.obstacle);
  return result;
}

std::string outcome_text(const Outcome& outcome) {
  std::string text = outcome.embraces_object ? "round the object" : "not round the object";
  if (outcome.slipped_off)
    text = filled_in("slipped off the object at {:.2f} s", outcome.slipped_off->time_s);
  if (outcome.knot_distance_m)
    text += filled_in(", the knot {} from it", length_text(*outcome.knot_distance_m, 3));
  return text;
}

}  // namespace ribbon
