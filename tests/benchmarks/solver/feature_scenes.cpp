#include "benchmarks/solver/feature_scenes.h"

#include <functional>
#include <utility>

#include "scene/fabric.h"

namespace ribbon {

namespace {

Scene bare(const Scene& full) {
  Scene scene = full;
  scene.springs = {};
  scene.air_resistance_per_s = 0;
  scene.gravity_m_s2.reset();
  scene.friction = 0;
  scene.ribbon.thickness_m = 0;
  scene.fastening.reset();
  scene.obstacle.reset();
  return scene;
}

class List {
 public:
  explicit List(const Scene& full) : scenes_{{"nothing but the gate", bare(full)}} {}

  // To what the scene before has.
  void add(std::string feature, const std::function<void(Scene&)>& change) {
    Scene scene = scenes_.back().scene;
    change(scene);
    scenes_.push_back({std::move(feature), std::move(scene)});
  }

  // In the place of what `full` has.
  void add_choice(std::string choice, Scene full, const std::function<void(Scene&)>& change) {
    change(full);
    scenes_.push_back({std::move(choice), std::move(full)});
  }

  std::vector<FeatureScene> scenes() && { return std::move(scenes_); }

 private:
  std::vector<FeatureScene> scenes_;
};

void add_all_features(const Scene& full, List& list) {
  list.add("+ stretch springs", [&](Scene& s) { s.springs.stretch = full.springs.stretch; });
  list.add("+ shear springs", [&](Scene& s) { s.springs.shear = full.springs.shear; });
  list.add("+ bending springs", [&](Scene& s) { s.springs.bend = full.springs.bend; });
  list.add("+ air", [&](Scene& s) { s.air_resistance_per_s = full.air_resistance_per_s; });
  list.add("+ obstacle", [&](Scene& s) { s.obstacle = full.obstacle; });
  list.add("+ fastening", [&](Scene& s) {
    s.fastening = full.fastening;
    s.fastening->yield_strain = unyielding;
    s.fastening->max_speed_m_s.reset();
  });
  list.add("+ `yield`", [](Scene& s) { s.fastening->yield_strain = 0.05; });
  list.add("+ `max_speed`",
           [](Scene& s) { s.fastening->max_speed_m_s = 4 * s.fastening->speed_m_s; });
  list.add("+ friction", [](Scene& s) { s.friction = 0.2; });
  list.add("+ thickness", [](Scene& s) { s.ribbon.thickness_m = 0.001; });
  list.add("+ gravity", [](Scene& s) { s.gravity_m_s2 = Eigen::Vector3d(0, -9.81, 0); });
}

// A hand that fastens all of the band as without stages, or a part of it.
HandScene all_of(const Scene& scene, const Span& part = {0, 1}) {
  return {.at = part,
          .task = HandTask::pull_along,
          .speed_m_s = scene.fastening->speed_m_s,
          .yield_strain = scene.fastening->yield_strain};
}

// One that carries an end of the band, and does not arrive while it is measured.
HandScene carried_end(const Scene& scene) {
  return {.at = Span{0.98, 1},
          .task = HandTask::carry,
          .speed_m_s = scene.fastening->speed_m_s,
          .carry = {.path = std::vector<Eigen::Vector2d>{{2000, 0}, {2500, 500}, {3000, 0}}}};
}

}  // namespace

std::vector<FeatureScene> feature_scenes(const Scene& full) {
  List list(full);
  add_all_features(full, list);
  const auto integrator = [](IntegrationMethod method) {
    return [=](Scene& s) { s.time.integrator = method; };
  };
  list.add_choice("sample, `rk4`", full, integrator(IntegrationMethod::rk4));
  list.add_choice("sample, `symplectic_euler`", full,
                  integrator(IntegrationMethod::symplectic_euler));
  list.add_choice("sample, `implicit`", full, integrator(IntegrationMethod::implicit));
  list.add_choice("sample, `pull = \"ends\"`", full,
                  [](Scene& s) { s.fastening->pull = FasteningPull::ends; });
  list.add_choice("sample, in a stage", full,
                  [](Scene& s) { s.stages = {{.hands = {all_of(s)}}}; });
  list.add_choice("sample, in a stage with gravity", full, [](Scene& s) {
    s.stages = {{.gravity_m_s2 = Eigen::Vector3d(0, -9.81, 0), .hands = {all_of(s)}}};
  });
  list.add_choice("sample, in a stage that carries an end", full, [](Scene& s) {
    s.stages = {{.hands = {all_of(s, {0, 0.9}), carried_end(s)}}};
  });
  list.add_choice("sample, width profile", full, [](Scene& s) {
    s.ribbon.profile = WidthProfile{{{0, 0.5 * s.ribbon.width_m}, {1, 1.5 * s.ribbon.width_m}}};
  });
  list.add_choice("sample, in silk", full, [](Scene& s) {
    s.cloth = {.fabric = fabrics.front(),
               .tells_mass = true,
               .tells_stretch = true,
               .tells_shear = true,
               .tells_bend = true};
  });
  list.add_choice("sample, `contact = \"paper\"`", full,
                  [](Scene& s) { s.contact = ContactMethod::paper; });
  return std::move(list).scenes();
}

}  // namespace ribbon
