#include "benchmarks/solver/extreme_scenes.h"

#include <functional>
#include <utility>

#include "simulation/loop_scene.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

using Change = std::function<void(Scene&)>;

constexpr double post_radius_m = 0.45;  // the loop's is 0.5: it soon comes to lie on it

double particle_mass_kg(const Scene& scene) {
  return scene.ribbon.mass_kg / (scene.ribbon.along * scene.ribbon.across);
}

void set_all_springs(double resistance, Scene& scene) {
  scene.springs = {.stretch = resistance, .shear = resistance, .bend = resistance};
}

class List {
 public:
  explicit List(int most_particles) : most_particles_(most_particles) {}

  ExtremeScene& add(std::string extreme, const Change& change) {
    Scene scene = scene_of_small_loop();
    change(scene);
    RibbonMesh mesh = mesh_of_loop(scene);
    return scenes_.emplace_back(
        ExtremeScene{std::move(extreme), std::move(scene), std::move(mesh), post(post_radius_m)});
  }

  void add_springs() {
    for (const double ratio : {0.0, 1.0, 1e2, 1e4, 3e4, 1e6, 1e8, 1e10, 1e12})
      add("k/m = " + short_number(ratio),
          [=](Scene& scene) { set_all_springs(ratio * particle_mass_kg(scene), scene); });
    add("bending only", [](Scene& scene) { scene.springs = {.bend = 10}; });
    add("stretch only", [](Scene& scene) { scene.springs = {.stretch = 10}; });
    add("k1 : k2 : k3 = 1e5 : 1 : 1e-5",
        [](Scene& scene) { scene.springs = {.stretch = 1e5, .shear = 1, .bend = 1e-5}; });
    add("k1 : k2 : k3 = 1e-5 : 1 : 1e5",
        [](Scene& scene) { scene.springs = {.stretch = 1e-5, .shear = 1, .bend = 1e5}; });
  }

  void add_nothing_at_all() {
    add("no springs, air, fastening or obstacle", [](Scene& scene) {
      scene.springs = {};
      scene.air_resistance_per_s = 0;
      scene.fastening.reset();
    }).obstacle.reset();
  }

  void add_steps() {
    for (const double step_s : {1e-5, 1e-4, 1e-3, 0.1})
      add("step " + short_number(step_s) + " s", [=](Scene& scene) {
        scene.time.step_s = step_s;
      }).steps = step_s < 1e-3 ? 1000 : 200;
  }

  void add_masses() {
    for (const double mass_kg : {1e-9, 1e9}) {
      add("mass " + short_number(mass_kg) + " kg, k/m as it was", [=](Scene& scene) {
        set_all_springs(10 * mass_kg / scene.ribbon.mass_kg, scene);
        scene.ribbon.mass_kg = mass_kg;
      });
      add("mass " + short_number(mass_kg) + " kg, k as it was",
          [=](Scene& scene) { scene.ribbon.mass_kg = mass_kg; });
    }
  }

  void add_lengths() {
    for (const double size : {1e-6, 1e6}) {
      ExtremeScene& scaled = add("lengths times " + short_number(size), [=](Scene& scene) {
        scene.ribbon.width_m *= size;
        scene.fastening->speed_m_s *= size;
      });
      scaled.mesh = mesh_of_loop(scaled.scene, size);
      scaled.obstacle->vertices *= static_cast<float>(size);
    }
  }

  void add_places() {
    for (const double lengths : {1e2, 1e6}) {
      ExtremeScene& far = add(short_number(lengths) + " lengths from the origin", [](Scene&) {});
      const Eigen::Vector3d place(lengths * far.mesh.length_m, 0, 0);
      far.mesh.positions.colwise() += place;
      far.obstacle->vertices.colwise() += place.cast<float>();
      far.scene.fastening->axis_point_m = place;
    }
  }

  void add_air() {
    add("no air, unfastened", [](Scene& scene) {
      scene.air_resistance_per_s = 0;
      scene.fastening.reset();
    });
    for (const double per_s : {1e-6, 1e3, 1e6, 1e12})
      add("air resistance " + short_number(per_s) + " /s",
          [=](Scene& scene) { scene.air_resistance_per_s = per_s; });
  }

  void add_gravity() {
    for (const double times : {1.0, 100.0})
      add("gravity x" + short_number(times),
          [=](Scene& scene) { scene.gravity_m_s2 = times * Eigen::Vector3d(0, 0, -9.81); });
  }

  void add_forces() {
    add("force x0", [](Scene& scene) { scene.fastening.reset(); });
    add("force x1", [](Scene&) {});
    const auto pull_hard = [](Scene& scene) { scene.fastening->speed_m_s *= 1000; };
    add("force x1000", pull_hard).steps = 50;
    add("force x1000, yield = 0.05", [=](Scene& scene) {
      pull_hard(scene);
      scene.fastening->yield_strain = 0.05;
    }).steps = 50;
    add("force x1000, max_speed = 1", [=](Scene& scene) {
      pull_hard(scene);
      scene.fastening->max_speed_m_s = 1;
    }).steps = 50;
  }

  void add_four_particles() {
    ExtremeScene& four = add("2x2 particles", [](Scene&) {});
    four.mesh = mesh_of_four_particles(four.scene);
  }

  // The particles of one size are as heavy as those of the other.
  void add_size(int across, int along, int steps) {
    if (across * along > most_particles_) return;
    add(std::to_string(across) + "x" + std::to_string(along) + " particles", [=](Scene& scene) {
      scene.ribbon.mass_kg = particle_mass_kg(scene) * across * along;
      scene.ribbon.along = along;
      scene.ribbon.across = across;
      scene.recording.max_position_error = 1e-6;  // short edges bear no more
    }).steps = steps;
  }

  void add_sizes() {
    add_four_particles();
    add_size(2, 80, 200);
    add_size(8, 400, 100);
    add_size(16, 800, 50);
    add_size(64, 1600, 10);
    add_size(64, 3200, 5);
  }

  std::vector<ExtremeScene> take() { return std::move(scenes_); }

 private:
  int most_particles_;
  std::vector<ExtremeScene> scenes_;
};

}  // namespace

std::vector<ExtremeScene> extreme_scenes(int most_particles) {
  List list(most_particles);
  list.add_springs();
  list.add_nothing_at_all();
  list.add_steps();
  list.add_masses();
  list.add_lengths();
  list.add_places();
  list.add_air();
  list.add_gravity();
  list.add_forces();
  list.add_sizes();
  return list.take();
}

}  // namespace ribbon
