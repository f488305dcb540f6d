#include "converter/comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "text/number_text.h"

namespace ribbon {

namespace {

// Of single precision: times and scales that are told so, and v that was turned upside down.
constexpr double single_precision = 1.2e-7;
constexpr double smallest_time_s = 1e-9;  // FBX counts in steps of 0.02 ns

bool alike(double a, double b) {
  return std::abs(a - b) <= single_precision * std::abs(b);
}

// Quads as the fans that some formats have to split them into.
Eigen::MatrixXi split(const Eigen::MatrixXi& quads) {
  Eigen::MatrixXi triangles(3, 2 * quads.cols());
  for (Eigen::Index quad = 0; quad < quads.cols(); ++quad) {
    const Eigen::Vector4i corners = quads.col(quad);
    triangles.col(2 * quad) << corners[0], corners[1], corners[2];
    triangles.col(2 * quad + 1) << corners[0], corners[2], corners[3];
  }
  return triangles;
}

bool same_faces(const Eigen::MatrixXi& written, const Eigen::MatrixXi& expected) {
  if (written.rows() == 3 && expected.rows() == 4) return same_faces(written, split(expected));
  return written.rows() == expected.rows() && written.cols() == expected.cols() &&
         written == expected;
}

bool same_uv(const Eigen::Matrix2Xd& written, const Eigen::Matrix2Xf& expected) {
  if (written.cols() != expected.cols()) return false;
  return written.cols() == 0 ||
         (written - expected.cast<double>()).cwiseAbs().maxCoeff() <= single_precision;
}

bool same_times(const std::vector<double>& times_s, double frames_per_second) {
  for (std::size_t frame = 0; frame < times_s.size(); ++frame) {
    const double expected_s = static_cast<double>(frame) / frames_per_second;
    if (std::abs(times_s[frame] - expected_s) > smallest_time_s &&
        !alike(times_s[frame], expected_s))
      return false;
  }
  return true;
}

bool is_worse(const Deviations& one, const Deviations& other) {
  if (one.within != other.within) return other.within;
  const double excess_m = one.largest_m - one.allowed_m;
  return one.within ? one.largest_m > other.largest_m
                    : excess_m > other.largest_m - other.allowed_m;
}

}  // namespace

void Deviations::add(const Deviations& other) {
  frames += other.frames;
  missing.insert(other.missing.begin(), other.missing.end());
  if (difference.empty()) difference = other.difference;
  if (is_worse(*this, other) || (frame > 0 && !is_worse(other, *this))) return;
  within = other.within;
  largest_m = other.largest_m;
  frame = other.frame;
  allowed_m = other.allowed_m;
}

Comparison::Comparison(Model model, const RecordingHeader& header, ComparisonSettings settings)
    : model_(std::move(model)),
      obstacle_(header.obstacle ? header.obstacle->vertices : Eigen::Matrix3Xf(3, 0)),
      settings_(settings) {}

void Comparison::see_difference(const std::string& what) {
  if (deviations_.difference.empty()) deviations_.difference = what;
}

bool Comparison::expect_ribbon(int number, const Eigen::Matrix3Xf& recorded) {
  if (model_.solid) {
    const auto posed = pose_ribbon(model_, recorded, number);
    if (!posed) see_difference(posed.error().sentence());
    if (posed && !*posed) return false;
  }
  const bool is_first = ribbon_.number == 0;
  ribbon_.number = number;
  ribbon_.positions =
      model_.solid ? model_.objects.front().positions.cast<double>() : placed(recorded);
  if (is_first) first_reach_ = ribbon_.positions.cwiseAbs().maxCoeff();
  ribbon_.allowed_m = allowed_m(recorded, ribbon_.positions);
  return true;
}

void Comparison::see_scene(const WrittenScene& scene, int frames, const std::string& place) {
  const Placement& placement = model_.placement;
  if (scene.frames != frames)
    see_difference(filled_in("{} holds {} frames instead of {}", place, scene.frames, frames));
  if (scene.metres_per_unit && !alike(*scene.metres_per_unit, placement.metres_per_unit))
    see_difference(filled_in("{} says that its unit is {:.6g} m instead of {:.6g} m", place,
                             *scene.metres_per_unit, placement.metres_per_unit));
  if (scene.z_is_up && *scene.z_is_up != (placement.up == UpAxis::z))
    see_difference(place + " says that another axis is up");
  if (!same_times(scene.times_s, model_.frames_per_second))
    see_difference(place + " says another frame rate");
  if (!scene.has_faces) return;
  if (scene.meshes.size() != model_.objects.size())
    return see_difference(filled_in("{} holds {} objects instead of {}", place, scene.meshes.size(),
                                    model_.objects.size()));
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    compare_mesh(scene.meshes[i], model_.objects[i], place);
}

void Comparison::compare_mesh(const WrittenMesh& mesh, const ModelObject& object,
                              const std::string& place) {
  if (!same_faces(mesh.faces, object.faces))
    see_difference(place + " has other faces in '" + object.name + "'");
  if (!same_uv(mesh.uv, object.uv))
    see_difference(place + " has other uv in '" + object.name + "'");
  if (object.moves) return;
  const Eigen::Matrix3Xd expected = placed(obstacle_);
  compare_positions(
      {.number = 0, .positions = expected, .allowed_m = allowed_m(obstacle_, expected)},
      mesh.positions);
}

void Comparison::see_ribbon(const Eigen::Matrix3Xd& written) {
  ++deviations_.frames;
  compare_positions(ribbon_, written);
}

void Comparison::compare_positions(const Expected& expected, const Eigen::Matrix3Xd& written) {
  const auto& [number, positions, allowed_m] = expected;
  const std::string what = number > 0 ? filled_in("frame {}", number) : "the obstacle";
  if (written.cols() != positions.cols())
    return see_difference(
        filled_in("{} has {} vertices instead of {}", what, written.cols(), positions.cols()));
  if (!written.allFinite()) return see_difference(what + " has a position that is not finite");
  if (positions.cols() == 0) return;
  const double largest = std::sqrt((written - positions).colwise().squaredNorm().maxCoeff());
  const double largest_m = largest / model_.placement.factor();
  deviations_.add({.within = largest_m <= allowed_m,
                   .largest_m = largest_m,
                   .frame = number,
                   .allowed_m = allowed_m,
                   .difference = ""});
}

// The placement once more, in double precision.
Eigen::Matrix3Xd Comparison::placed(const Eigen::Matrix3Xf& recorded) const {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (model_.placement.up == UpAxis::z) axes << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const double units = model_.placement.scale / model_.placement.metres_per_unit;
  return units * (axes * recorded.cast<double>());
}

double Comparison::allowed_m(const Eigen::Matrix3Xf& recorded,
                             const Eigen::Matrix3Xd& expected) const {
  if (settings_.tolerance_m) return *settings_.tolerance_m;
  if (recorded.cols() == 0) return 0;
  const double reach = std::max(first_reach_, expected.cwiseAbs().maxCoeff());
  return model_.placement.rounding_m(recorded) +
         std::sqrt(3.0) * settings_.format_rounding * reach / model_.placement.factor();
}

}  // namespace ribbon
