// Keyframes of a camera, from a file.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "player/view/view.h"
#include "result/result.h"

namespace ribbon {

// Where a camera stands at a time.
struct CameraPose {
  View view;
  std::optional<Eigen::Vector3f> target;  // metres; nothing: the middle of the subject
};

// A smooth way through keyframes: it passes each of them at its time, at an even pace (cubic, with
// the tangents of Catmull and Rom). Before the first and after the last it stands still.
class CameraPath {
 public:
  // A table as spreadsheets write it: a first line that names the columns, numbers separated by
  // commas below. Columns: time (seconds, ascending), and any of azimuth, elevation (degrees),
  // distance (metres), lens (mm), x, y, z (metres, all three or none: what is looked at); what is
  // left out is as in `start`. `name` stands in errors, which tell the line.
  static Result<CameraPath> parse(const std::string& text, const std::string& name,
                                  const View& start);
  static Result<CameraPath> read(const std::filesystem::path& file, const View& start);

  [[nodiscard]] CameraPose at(double time_s) const;

 private:
  // azimuth, elevation, distance, lens, x, y, z.
  static constexpr int channels = 7;
  using Values = Eigen::Array<double, channels, 1>;
  CameraPath(View start, bool has_target) : start_(start), has_target_(has_target) {}
  [[nodiscard]] Values tangent(std::size_t key) const;

  View start_;
  bool has_target_;
  std::vector<double> times_s_;
  std::vector<Values> values_;
};

}  // namespace ribbon
