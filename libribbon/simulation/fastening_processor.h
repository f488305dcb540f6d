// The fastening deformation processor (paper, section 5, Figure 5).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "geometry/triangle_mesh.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "ribbon_mesh/springs.h"
#include "scene/scene.h"
#include "simulation/bodies.h"
#include "simulation/cloth.h"
#include "simulation/contact.h"
#include "simulation/fastening_force.h"
#include "simulation/strain_correction.h"
#include "simulation/yielding.h"

namespace ribbon {

// What one step brought about.
struct StepReport {
  int recovery_iterations = 0;  // of Figure 15
};

// Fastens one ribbon, step by step. What the scene does not name (springs, obstacle, fastening) is
// neither held in memory nor computed. Equal scenes give equal bits for any number of threads.
class FasteningProcessor {
 public:
  FasteningProcessor(const Scene& scene, const RibbonMesh& ribbon,
                     const std::optional<TriangleMesh>& obstacle);

  StepReport step();

  // How many distinct edges pierce a triangle now, ribbon and obstacle together. Costs a detection.
  [[nodiscard]] int penetrating_edges();

  // Largest |length / rest length - 1| of the stretch and shear springs now.
  [[nodiscard]] double strain() const;

  // 3 x particles, metres.
  [[nodiscard]] Eigen::Matrix3Xd positions() const;
  [[nodiscard]] double time_s() const { return static_cast<double>(steps_) * step_s_; }

 private:
  Eigen::Matrix3Xd fastening_force();
  void settle();
  bool correct_strain();

  double step_s_;
  double air_resistance_per_s_;
  long steps_ = 0;
  Cloth cloth_;
  SpringNetwork springs_;
  int substeps_ = 1;
  std::optional<FasteningForce> fastening_;
  std::optional<Yielding> yielding_;
  std::unique_ptr<Bodies> bodies_;  // at a fixed place: the contact refers to it
  StrainCorrection strain_correction_;
  std::unique_ptr<Contact> contact_;
};

}  // namespace ribbon
