#include "player/view/camera_work.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "player/view/framing.h"
#include "player/view/orbit.h"
#include "player/view/scene_model.h"

namespace ribbon {

namespace {

constexpr int degrees_between = 15;  // the directions from which a moving camera is tried
// By so much further out may be what it sees in between.
constexpr float between_factor = 1.01F;

bool looks_at_knot(const Shot& shot) {
  return shot.view.subject == Subject::knot;
}

bool is_still(const Shot& shot) {
  return shot.turns == 0 && !shot.path && shot.view.distance_m == 0 && !looks_at_knot(shot);
}

// The directions from which a shot may look at everything, closely enough to find the distance from
// which everything fits.
std::vector<Framing> framings_of(const Shot& shot) {
  std::vector<Framing> framings{Framing(shot.view, shot.size)};
  if (is_still(shot) || looks_at_knot(shot)) return framings;
  View view = shot.view;
  for (int down = -90; down <= 90; down += degrees_between) {
    if (shot.path) view.elevation_deg = static_cast<float>(down);
    for (int round = 0; round < 360; round += degrees_between) {
      view.azimuth_deg = static_cast<float>(round);
      framings.emplace_back(view, shot.size);
    }
    if (!shot.path) break;
  }
  return framings;
}

struct Extent {
  Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Vector3f high = -low;

  void include(const Eigen::Matrix3Xf& points) {
    if (points.cols() == 0) return;
    low = low.cwiseMin(points.rowwise().minCoeff());
    high = high.cwiseMax(points.rowwise().maxCoeff());
  }
  [[nodiscard]] Sphere sphere() const { return {(low + high) / 2, (high - low).norm() / 2}; }
};

bool is_empty(const Sphere& sphere, const Eigen::Matrix3Xf& points) {
  return (points.colwise() - sphere.center).colwise().squaredNorm().minCoeff() >
         sphere.radius_m * sphere.radius_m;
}

}  // namespace

CameraWork::CameraWork(RecordingReader& reader, std::vector<Shot> shots)
    : scale_(model_scale(reader.header())),
      shots_(std::move(shots)),
      frames_per_second_(reader.header().frames_per_second),
      follows_knot_(std::any_of(shots_.begin(), shots_.end(), looks_at_knot)) {
  std::vector<std::vector<Framing>> framings;
  for (const Shot& shot : shots_) framings.push_back(framings_of(shot));
  Extent extent;
  const auto include = [&](const Eigen::Matrix3Xf& points) {
    extent.include(points);
    for (auto& directions : framings)
      for (Framing& framing : directions) framing.include(points);
  };
  if (reader.header().obstacle) include(scale_ * reader.header().obstacle->vertices);
  Eigen::Matrix3Xf positions;
  for (int index = 0; index < reader.frame_count(); ++index) {
    const bool is_there = read(reader, index, positions);
    if (is_there) include(positions);
    if (follows_knot_) add_knot(reader.header(), is_there ? &positions : nullptr);
  }
  everything_ = extent.sphere();
  lowest_m_ = extent.low.y();
  for (const auto& directions : framings) {
    still_.push_back(directions.front().camera());
    float distance_m = 0;
    for (const Framing& framing : directions)
      distance_m = std::max(distance_m, framing.distance_from(everything_.center));
    distances_.push_back(distance_m * between_factor);
  }
}

void CameraWork::follow(RecordingReader& reader) {
  if (!follows_knot_) return;
  Eigen::Matrix3Xf positions;
  for (int index = knot_.frame_count(); index < reader.frame_count(); ++index) {
    const bool is_there = read(reader, index, positions);
    add_knot(reader.header(), is_there ? &positions : nullptr);
  }
}

bool CameraWork::read(RecordingReader& reader, int index, Eigen::Matrix3Xf& positions) const {
  if (!reader.readable(index) || !reader.read(index, positions)) return false;
  positions *= scale_;
  return true;
}

void CameraWork::add_knot(const RecordingHeader& header, const Eigen::Matrix3Xf* positions) {
  std::optional<Sphere> sphere;
  if (positions != nullptr) {
    sphere = knot_sphere(header.grid, static_cast<float>(scale_ * header.ribbon_width_m),
                         static_cast<float>(scale_ * header.ribbon_length_m), *positions);
    if (sphere) {
      last_knot_ = sphere;
    } else if (last_knot_ && is_empty(*last_knot_, *positions)) {
      Extent ribbon;
      ribbon.include(*positions);
      sphere = ribbon.sphere();
    }
  }
  knot_.add(knot_.frame_count() / frames_per_second_, sphere);
}

Sphere CameraWork::subject(Subject subject, const Moment& moment) const {
  if (subject == Subject::everything) return everything_;
  const auto knot = knot_.at(moment.frame);
  if (!knot || moment.after == 0) return knot.value_or(everything_);
  const Sphere next = *knot_.at(moment.frame + 1);
  const auto share = static_cast<float>(moment.after);
  return {knot->center + share * (next.center - knot->center),
          knot->radius_m + share * (next.radius_m - knot->radius_m)};
}

CameraPose CameraWork::pose(const Shot& shot, const Moment& moment) const {
  CameraPose pose{shot.view, std::nullopt};
  if (shot.path) pose = shot.path->at((moment.frame + moment.after) / frames_per_second_);
  pose.view.azimuth_deg += static_cast<float>(360 * shot.turns * moment.progress);
  return pose;
}

Camera CameraWork::camera(std::size_t number, const Moment& moment) const {
  const Shot& shot = shots_[number];
  if (is_still(shot)) return still_[number];
  const CameraPose pose = this->pose(shot, moment);
  const Sphere looked_at = subject(pose.view.subject, moment);
  float distance_m = scale_ * pose.view.distance_m;
  if (distance_m == 0)
    distance_m = looks_at_knot(shot) ? distance_to_hold(looked_at.radius_m, pose.view, shot.size)
                                     : distances_[number] * pose.view.lens_mm / shot.view.lens_mm;
  const Eigen::Vector3f target = pose.target ? scale_ * *pose.target : looked_at.center;
  return orbit_camera(pose.view, shot.size, target, distance_m);
}

}  // namespace ribbon
