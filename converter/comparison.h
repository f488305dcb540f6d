// What a file holds, beside what was recorded.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "converter/read_back/written_motion.h"
#include "model/model.h"

namespace ribbon {

struct ComparisonSettings {
  // How far a vertex may be from where it was recorded, in recorded metres; nothing: as far as the
  // format, the unit and the scale are stated to round.
  std::optional<double> tolerance_m;
  // Of a coordinate, relative to the largest one of this frame and the first, from which motion may
  // be told: what the format rounds by, beside the placement.
  double format_rounding = 0;
};

// The outcome so far. Deviations are distances in recorded metres.
struct Deviations {
  int frames = 0;          // that were compared
  bool within = true;      // all that was allowed
  double largest_m = 0;    // or, where not all is within, that which exceeds most what is allowed
  int frame = 0;           // where that is, from 1; 0: nowhere, or in the obstacle
  double allowed_m = 0;    // there
  std::string difference;  // the first one of another kind, in words; empty: none
  std::set<int> missing = {};  // frames, from 1, of which nothing can be said: they are lost

  [[nodiscard]] bool good() const { return within && difference.empty(); }
  // As if `other` had been seen after it.
  void add(const Deviations& other);
};

// Compares with a recording. Where the model's ribbon is a surface, its positions are worked out
// anew in double precision, without the code that writers use; a solid is raised again.
class Comparison {
 public:
  // model: as it was written.
  Comparison(Model model, const RecordingHeader& header, ComparisonSettings settings);

  // Expects the ribbon of a frame, by its number from 1. False where it cannot be made a solid, so
  // that it was not written; the one before it is then still expected.
  [[nodiscard]] bool expect_ribbon(int number, const Eigen::Matrix3Xf& recorded);
  // What no frame changes, of `frames` frames; `place` is named where it differs.
  void see_scene(const WrittenScene& scene, int frames, const std::string& place);
  // One frame, where that ribbon should be.
  void see_ribbon(const Eigen::Matrix3Xd& written);
  // The recording has lost a frame.
  void see_lost(int number) { deviations_.missing.insert(number); }
  // Something else is wrong.
  void see_difference(const std::string& what);

  [[nodiscard]] const Deviations& deviations() const { return deviations_; }

 private:
  struct Expected {
    int number = 0;  // of the frame; 0: of the obstacle
    Eigen::Matrix3Xd positions = Eigen::Matrix3Xd(3, 0);
    double allowed_m = 0;
  };

  [[nodiscard]] Eigen::Matrix3Xd placed(const Eigen::Matrix3Xf& recorded) const;
  [[nodiscard]] double allowed_m(const Eigen::Matrix3Xf& recorded,
                                 const Eigen::Matrix3Xd& expected) const;
  void compare_mesh(const WrittenMesh& mesh, const ModelObject& object, const std::string& place);
  void compare_positions(const Expected& expected, const Eigen::Matrix3Xd& written);

  Model model_;
  Eigen::Matrix3Xf obstacle_;  // as recorded
  ComparisonSettings settings_;
  Expected ribbon_;
  double first_reach_ = 0;  // the largest coordinate of the first ribbon, in the files' unit
  Deviations deviations_;
};

}  // namespace ribbon
