// What holds for every integrator, each within its own bounds.
#include "simulation/integration/integrator.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "parallel/any_threads.h"
#include "simulation/integration/spring_networks.h"

namespace ribbon::integrator_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

std::string name_of(IntegrationMethod method) {
  if (method == IntegrationMethod::rk4) return "rk4";
  return method == IntegrationMethod::implicit ? "implicit" : "symplectic_euler";
}

class AnyIntegrator : public testing::TestWithParam<IntegrationMethod> {};

INSTANTIATE_TEST_SUITE_P(Integrator, AnyIntegrator,
                         testing::Values(IntegrationMethod::rk4,
                                         IntegrationMethod::symplectic_euler,
                                         IntegrationMethod::implicit),
                         [](const auto& method) { return name_of(method.param); });

// A flat band at rest, its edges 0.1 m long.
struct Band {
  RibbonGrid grid;
  SpringScene stiffness;
  SpringNetwork springs = springs_of_size(1);
  double air_resistance_per_s = 0;
  std::optional<Vector3d> gravity_m_s2;
  Matrix3Xd force = Matrix3Xd(3, 0);
  Cloth cloth;

  explicit Band(double stretch = 20, double mass_kg = 0.02, RibbonGrid particles = {10, 5})
      : grid(particles),
        stiffness{.stretch = stretch, .shear = 0.7 * stretch, .bend = 0.3 * stretch, .damping = 0} {
    cloth.particle_mass_kg = mass_kg;
    cloth.positions.resize(3, grid.particle_count());
    cloth.velocities = Matrix3Xd::Zero(3, grid.particle_count());
    for (int p = 0; p < grid.particle_count(); ++p)
      cloth.positions.col(p) << 0.1 * grid.row(p), 0.1 * grid.column(p), 0;
  }

  [[nodiscard]] SpringNetwork springs_of_size(double size) const {
    return spring_network({grid, size * 0.1 * (grid.along - 1), size * 0.1 * (grid.across - 1)},
                          stiffness);
  }

  // Smooth waves, a turn and a drift.
  void throw_it() {
    for (int p = 0; p < grid.particle_count(); ++p) {
      const Vector3d x = cloth.positions.col(p);
      cloth.velocities.col(p) =
          Vector3d(0.3 * std::sin(5 * x[0]), 0.2 * std::cos(4 * x[0]), 0.5 * std::sin(6 * x[0])) +
          Vector3d(0, 0, 2).cross(x) + Vector3d(0.1, 0.2, 0.3);
    }
  }

  void crumple(double distance_m) {
    std::mt19937 random(7);
    for (double& value : cloth.positions.reshaped())
      value += distance_m * (2e-9 * static_cast<double>(random() % 1'000'000'000) - 1);
  }

  void scale(double size) {
    cloth.positions *= size;
    cloth.velocities *= size;
    springs = springs_of_size(size);
  }

  // From half of its width to one and a half, and flat again.
  void taper() {
    RestSize size{grid, 0.1 * (grid.along - 1), 0.1 * (grid.across - 1)};
    for (int row = 0; row < grid.along; ++row)
      size.row_widths_m.push_back(size.width_m *
                                  (0.5 + static_cast<double>(row) / (grid.along - 1)));
    springs = spring_network(size, stiffness);
    cloth.lightness = lightness(size);
    for (int p = 0; p < grid.particle_count(); ++p) cloth.positions.col(p) << size.place_m(p), 0;
  }

  // kg, of each particle.
  [[nodiscard]] Eigen::VectorXd masses() const {
    Eigen::VectorXd masses = Eigen::VectorXd::Constant(grid.particle_count(), 1);
    if (cloth.lightness.size() > 0) masses = cloth.lightness.inverse();
    return cloth.particle_mass_kg * masses;
  }

  [[nodiscard]] std::unique_ptr<Integrator> integrator(IntegrationMethod method,
                                                       double step_s) const {
    return create_integrator(method, springs,
                             {.step_s = step_s,
                              .particle_mass_kg = cloth.particle_mass_kg,
                              .air_resistance_per_s = air_resistance_per_s,
                              .gravity_m_s2 = gravity_m_s2,
                              .lightness = cloth.lightness});
  }

  void advance(IntegrationMethod method, double step_s, int steps) {
    const auto chosen = integrator(method, step_s);
    for (int i = 0; i < steps; ++i) chosen->displace(force, cloth);
  }

  [[nodiscard]] double energy_j() const {
    return (cloth.velocities.colwise().squaredNorm() * masses()).value() / 2 +
           elastic_energy_j(springs, cloth.positions);
  }

  [[nodiscard]] Vector3d angular_momentum() const {
    Vector3d sum = Vector3d::Zero();
    for (int p = 0; p < grid.particle_count(); ++p)
      sum += cloth.particle_mass_kg *
             Vector3d(cloth.positions.col(p)).cross(Vector3d(cloth.velocities.col(p)));
    return sum;
  }
};

TEST_P(AnyIntegrator, a_flat_band_with_a_profile_stays_as_it_is) {
  Band band;
  band.taper();
  const Matrix3Xd before = band.cloth.positions;
  band.advance(GetParam(), 0.01, 50);
  EXPECT_LT((band.cloth.positions - before).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_P(AnyIntegrator, of_rows_that_weigh_differently_keeps_the_momentum) {
  Band band;
  band.taper();
  band.throw_it();
  const Vector3d before = band.cloth.velocities * band.masses();
  const double energy_j = band.energy_j();
  band.advance(GetParam(), 0.002, 100);
  EXPECT_LT((band.cloth.velocities * band.masses() - before).norm(), 1e-9);
  EXPECT_LT(band.energy_j(), 1.05 * energy_j);
}

// An exact solution, of what weighs differently: the same in small steps.
TEST_P(AnyIntegrator, of_rows_that_weigh_differently_goes_where_small_steps_go) {
  const auto thrown = [](IntegrationMethod method, int steps) {
    Band band;
    band.taper();
    band.throw_it();
    band.advance(method, 0.1 / steps, steps);
    return band.cloth.positions;
  };
  const Matrix3Xd exact = thrown(IntegrationMethod::rk4, 1000);
  EXPECT_LT((thrown(GetParam(), 400) - exact).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_GT((thrown(GetParam(), 400) - Band().cloth.positions).cwiseAbs().maxCoeff(), 1e-2);
}

Matrix3Xd thrown_for_a_fifth_second(IntegrationMethod method, int steps) {
  Band band;
  band.throw_it();
  band.air_resistance_per_s = 0.5;
  band.advance(method, 0.2 / steps, steps);
  return band.cloth.positions;
}

double order_of(IntegrationMethod method, int steps) {
  const Matrix3Xd exact = thrown_for_a_fifth_second(IntegrationMethod::rk4, 2000);
  const auto error = [&](int count) {
    return (thrown_for_a_fifth_second(method, count) - exact).norm();
  };
  return std::log2(error(steps) / error(2 * steps));
}

TEST(Integrator, converges_with_the_order_of_its_scheme) {
  EXPECT_NEAR(order_of(IntegrationMethod::rk4, 20), 4, 0.1);
  EXPECT_NEAR(order_of(IntegrationMethod::symplectic_euler, 40), 1, 0.02);
  EXPECT_NEAR(order_of(IntegrationMethod::implicit, 320), 1, 0.04);
}

TEST_P(AnyIntegrator, keeps_momentum_in_free_flight) {
  Band band;
  band.throw_it();
  band.crumple(0.01);
  const Vector3d before = band.cloth.velocities.rowwise().sum();
  band.advance(GetParam(), 0.01, 100);
  const Vector3d after = band.cloth.velocities.rowwise().sum();
  EXPECT_LT((after - before).norm(), 1e-12 * before.norm());
}

TEST(Integrator, keeps_angular_momentum_in_free_flight_unless_it_damps) {
  const auto loss = [](IntegrationMethod method) {
    Band band;
    band.throw_it();
    const Vector3d before = band.angular_momentum();
    band.advance(method, 0.01, 100);
    return (band.angular_momentum() - before).norm() / before.norm();
  };
  EXPECT_LT(loss(IntegrationMethod::rk4), 1e-6);
  EXPECT_LT(loss(IntegrationMethod::symplectic_euler), 1e-13);
}

struct EnergyRange {
  double lowest = 1;  // of the energy at the start
  double highest = 1;
  double highest_rise = 0;  // of one step
};

EnergyRange energy_in_free_flight(IntegrationMethod method, Band band, double step_s, int steps) {
  const double start_j = band.energy_j();
  const auto integrator = band.integrator(method, step_s);
  EnergyRange range;
  double last = 1;
  for (int i = 0; i < steps; ++i) {
    integrator->displace(band.force, band.cloth);
    const double energy = band.energy_j() / start_j;
    range.lowest = std::min(range.lowest, energy);
    range.highest = std::max(range.highest, energy);
    range.highest_rise = std::max(range.highest_rise, energy - last);
    last = energy;
  }
  return range;
}

TEST(Integrator, keeps_energy_in_free_flight_as_its_scheme_does) {
  Band band;
  band.throw_it();
  const EnergyRange rk4 = energy_in_free_flight(IntegrationMethod::rk4, band, 0.01, 300);
  EXPECT_GT(rk4.lowest, 0.999);  // it damps slightly
  EXPECT_LE(rk4.highest, 1);
  const EnergyRange symplectic =
      energy_in_free_flight(IntegrationMethod::symplectic_euler, band, 0.01, 3000);
  EXPECT_GT(symplectic.lowest, 0.99);  // however long
  EXPECT_LT(symplectic.highest, 1.01);
  const EnergyRange implicit = energy_in_free_flight(IntegrationMethod::implicit, band, 0.01, 300);
  EXPECT_LT(implicit.lowest, 0.95);
  EXPECT_LT(implicit.highest_rise, 1e-12);
}

TEST(Integrator, air_slows_a_free_particle_exponentially_when_steps_are_short) {
  const auto speed_after_one_second = [](IntegrationMethod method, int steps) {
    Band band(0);
    band.cloth.velocities.setOnes();
    band.air_resistance_per_s = 2;
    band.advance(method, 1.0 / steps, steps);
    return band.cloth.velocities(1, 7);
  };
  EXPECT_NEAR(speed_after_one_second(IntegrationMethod::rk4, 100), std::exp(-2.0), 1e-8);
  for (const auto method : {IntegrationMethod::symplectic_euler, IntegrationMethod::implicit})
    for (const int steps : {100, 10'000})  // by hand: (1 + 2 / n)^-n = exp(-2) (1 + 2 / n + ...)
      EXPECT_NEAR(speed_after_one_second(method, steps) / std::exp(-2.0) - 1, 2.0 / steps,
                  4.0 / steps / steps);
}

TEST_P(AnyIntegrator, brings_a_constant_force_to_the_speed_at_which_air_resists_as_much) {
  Band band;
  band.air_resistance_per_s = 5;
  band.force = Matrix3Xd::Zero(3, band.grid.particle_count());
  band.force.row(2).setConstant(3 * band.cloth.particle_mass_kg);  // 3 m/s^2 against 5/s: 0.6 m/s
  band.advance(GetParam(), 0.01, 500);
  EXPECT_LT((band.cloth.velocities.row(2).array() - 0.6).abs().maxCoeff(), 1e-9);
}

// By hand: v = g / c (1 - exp(-c t)), x = g / c (t - (1 - exp(-c t)) / c). Schemes of first order
// are wrong by half a step's worth of the acceleration.
TEST(Integrator, falls_in_air_as_a_free_particle_does) {
  const Vector3d gravity(1, -9.81, 2);
  constexpr double air = 4, time_s = 0.5;
  const double lost = 1 - std::exp(-air * time_s);
  for (const auto method :
       {IntegrationMethod::rk4, IntegrationMethod::symplectic_euler, IntegrationMethod::implicit}) {
    SCOPED_TRACE(name_of(method));
    const auto error = [&](int steps) {
      Band band;
      band.air_resistance_per_s = air;
      band.gravity_m_s2 = gravity;
      const Matrix3Xd before = band.cloth.positions;
      band.advance(method, time_s / steps, steps);
      const Vector3d fallen = gravity / air * (time_s - lost / air);
      return std::pair(((band.cloth.velocities.colwise() - gravity / air * lost)).norm(),
                       ((band.cloth.positions - before).colwise() - fallen).norm());
    };
    const auto [speed_error, place_error] = error(50);
    const auto [half_speed_error, half_place_error] = error(100);
    const double order = method == IntegrationMethod::rk4 ? 4 : 1;
    EXPECT_NEAR(std::log2(speed_error / half_speed_error), order, 0.1);
    EXPECT_NEAR(std::log2(place_error / half_place_error), order, 0.1);
    EXPECT_LT(half_speed_error, 0.01 * gravity.norm() * std::sqrt(50) / air);
  }
}

TEST_P(AnyIntegrator, falls_at_last_as_fast_as_air_lets_it) {
  Band band;
  band.air_resistance_per_s = 5;
  band.gravity_m_s2 = Vector3d(0, -9.81, 0);
  band.advance(GetParam(), 0.01, 500);
  EXPECT_LT((band.cloth.velocities.colwise() - Vector3d(0, -9.81 / 5, 0)).cwiseAbs().maxCoeff(),
            1e-9);
}

// Weight does no work about the centre of mass: all that is swung before is swung on the way down.
TEST_P(AnyIntegrator, gravity_adds_the_same_momentum_to_all_and_nothing_else) {
  Band band;
  band.throw_it();
  band.crumple(0.01);
  Band falling = band;
  falling.gravity_m_s2 = Vector3d(3, -9.81, 1);
  band.advance(GetParam(), 0.01, 50);
  falling.advance(GetParam(), 0.01, 50);
  const Matrix3Xd gained = falling.cloth.velocities - band.cloth.velocities;
  EXPECT_LT((gained.rowwise().mean() - 0.5 * *falling.gravity_m_s2).norm(), 1e-12);
  const double tolerated_m_s = GetParam() == IntegrationMethod::implicit ? 0.1 : 1e-9;
  EXPECT_LT((gained.colwise() - 0.5 * *falling.gravity_m_s2).cwiseAbs().maxCoeff(), tolerated_m_s);
}

TEST(Integrator, moves_without_springs_as_a_particle_does) {
  // By hand: 4 m/s^2 and 5/s for one step of 0.1 s from 3 m/s: (3 + 0.4) / 1.5 m/s.
  for (const auto method : {IntegrationMethod::symplectic_euler, IntegrationMethod::implicit}) {
    Band band(0);
    band.air_resistance_per_s = 5;
    band.cloth.velocities.setConstant(3);
    band.force =
        Matrix3Xd::Constant(3, band.grid.particle_count(), 4 * band.cloth.particle_mass_kg);
    const Matrix3Xd before = band.cloth.positions;
    band.advance(method, 0.1, 1);
    EXPECT_LT((band.cloth.velocities.array() - 3.4 / 1.5).abs().maxCoeff(), 1e-15);
    EXPECT_LT(
        (band.cloth.positions - before - Matrix3Xd::Constant(3, before.cols(), 0.34 / 1.5)).norm(),
        1e-14);
  }
}

TEST_P(AnyIntegrator, leaves_a_flat_ribbon_at_rest_where_it_is) {
  Band band;
  const Matrix3Xd before = band.cloth.positions;
  band.advance(GetParam(), 0.01, 100);
  EXPECT_LT((band.cloth.positions - before).norm(), 1e-13);
}

// Of several runs of particles, the last of them short.
TEST_P(AnyIntegrator, moves_each_particle_of_a_long_ribbon) {
  Band band(20, 0.02, {500, 5});
  band.cloth.velocities.row(2).setConstant(3);
  const Matrix3Xd before = band.cloth.positions;
  band.advance(GetParam(), 0.01, 2);
  EXPECT_LT(((band.cloth.positions - before).row(2).array() - 0.06).abs().maxCoeff(), 1e-12);
  EXPECT_LT((band.cloth.velocities.row(2).array() - 3).abs().maxCoeff(), 1e-10);
}

TEST_P(AnyIntegrator, computes_the_same_bits_for_any_number_of_threads) {
  same_for_any_threads([] {
    Band band(20, 0.02, {500, 5});
    band.throw_it();
    band.crumple(0.01);
    band.advance(GetParam(), 0.01, 5);
    return band.cloth.positions;
  });
}

// Crumpled by a third of its edges and thrown: the energy stays what it was, within the factor that
// the scheme allows.
void expect_bounded(IntegrationMethod method, double stiffness_per_mass, double step_s,
                    double mass_kg, double size, double most) {
  SCOPED_TRACE(name_of(method) + ", k/m " + std::to_string(stiffness_per_mass) + ", step " +
               std::to_string(step_s) + ", mass " + std::to_string(mass_kg) + ", size " +
               std::to_string(size));
  Band band(stiffness_per_mass * mass_kg, mass_kg);
  band.throw_it();
  band.crumple(0.03);
  band.scale(size);
  const EnergyRange energy = energy_in_free_flight(method, band, step_s, 5);
  EXPECT_TRUE(std::isfinite(energy.highest + energy.lowest));
  EXPECT_LT(energy.highest, most);
}

// From rest a force presses on a corner. Until contact has answered to it, no neighbour feels it
// but by the springs.
TEST_P(AnyIntegrator, damping_hands_on_nothing_that_contact_takes_back) {
  const auto after_the_first_part = [](double damping) {
    Band band;
    band.stiffness.damping = damping;
    band.springs = band.springs_of_size(1);
    band.force = Matrix3Xd::Zero(3, band.grid.particle_count());
    band.force.col(0) << -1, -1, -1;
    const auto integrator = band.integrator(GetParam(), 0.01);
    integrator->hold_force(band.force, band.cloth);
    integrator->displace_in_substep(band.cloth);
    return band.cloth;
  };
  const Cloth undamped = after_the_first_part(0);
  const Cloth damped = after_the_first_part(1);
  EXPECT_LT(undamped.velocities(0, 0), 0);
  EXPECT_EQ(damped.velocities, undamped.velocities);
  EXPECT_EQ(damped.positions, undamped.positions);
}

TEST(Integrator, is_stable_wherever_it_does_not_need_too_many_parts) {
  for (const double stiffness_per_mass : {0.0, 1.0, 1e2, 1e4, 3.2e4, 1e6, 1e8})
    for (const double step_s : {1e-5, 1e-3, 1e-2, 0.1}) {
      if (std::sqrt(stiffness_per_mass) * step_s > 100) continue;
      for (const double size : {1e-6, 1.0, 1e6}) {
        expect_bounded(IntegrationMethod::rk4, stiffness_per_mass, step_s, 0.02, size, 1.01);
        expect_bounded(IntegrationMethod::symplectic_euler, stiffness_per_mass, step_s, 0.02, size,
                       4.8);
      }
    }
}

// A flat band of oblong quads that trembles in its plane, for 300 parts: how fast it trembles
// then, over how fast it did at first.
double tremor_left(IntegrationMethod method, const SpringScene& springs, double oblong) {
  const RestSize size{{24, 8}, 0.01 * 23, 0.01 / oblong * 7};
  Cloth cloth{Matrix3Xd(3, size.grid.particle_count()),
              Matrix3Xd::Zero(3, size.grid.particle_count()), 1e-5};
  std::mt19937 random(7);
  for (int p = 0; p < size.grid.particle_count(); ++p) {
    cloth.positions.col(p) << size.along_m() * size.grid.row(p),
        size.across_m() * size.grid.column(p), 0;
    for (int axis = 0; axis < 2; ++axis)
      cloth.velocities(axis, p) = 1e-7 * (static_cast<double>(random()) / 0x1p32 - 0.5);
  }
  const double before = cloth.velocities.norm();
  const auto integrator =
      create_integrator(method, spring_network(size, springs), {0.01, cloth.particle_mass_kg, 0});
  for (int part = 0; part < 300; part += integrator->substeps())
    integrator->displace(Matrix3Xd(3, 0), cloth);
  return cloth.velocities.norm() / before;
}

// Where shear resists most and quads are oblong, all springs pull along one side. What damping
// stops springs throw back the farther the longer the part is.
TEST(Integrator, is_stable_with_any_damping_and_mixture_of_springs_on_any_quads) {
  for (const double oblong : {0.1, 1.0, 8.0})
    for (const double shear : {0.0, 1.0, 30.0})
      for (const double bend : {0.0, 1.0, 30.0})
        for (const double stretch : {0.0, 1.0})
          for (const double damping : {0.0, 0.5, 2.0, 100.0}) {
            const SpringScene springs{
                .stretch = stretch, .shear = shear, .bend = bend, .damping = damping};
            for (const auto method : {IntegrationMethod::rk4, IntegrationMethod::symplectic_euler})
              EXPECT_LT(tremor_left(method, springs, oblong), 1.1)
                  << name_of(method) << ", oblong " << oblong << ", springs " << stretch << " "
                  << shear << " " << bend << ", damping " << damping;
          }
}

TEST(Integrator, implicit_is_stable_everywhere) {
  for (const double stiffness_per_mass : {0.0, 1.0, 1e4, 1e6, 1e8, 1e10, 1e12})
    for (const double step_s : {1e-5, 1e-3, 1e-2, 0.1})
      for (const double mass_kg : {1e-9, 1e9})
        for (const double size : {1e-6, 1.0, 1e6})
          expect_bounded(IntegrationMethod::implicit, stiffness_per_mass, step_s, mass_kg, size,
                         1 + 1e-11);
}

TEST(Integrator, implicit_divides_a_step_as_if_it_were_so_much_shorter) {
  Band whole;
  whole.taper();
  whole.throw_it();
  whole.air_resistance_per_s = 2;
  whole.gravity_m_s2 = Vector3d(0, -9.81, 0);
  Band parts = whole;
  whole.advance(IntegrationMethod::implicit, 0.01, 8);
  const auto divided = parts.integrator(IntegrationMethod::implicit, 0.04);
  EXPECT_EQ(divided->substeps(), 1);
  for (int step = 0; step < 2; ++step) {
    divided->divide_steps(2 + 2 * step);
    divided->divide_steps(4);
    divided->displace(parts.force, parts.cloth);
  }
  EXPECT_EQ(divided->substeps(), 4);
  EXPECT_EQ(parts.cloth.positions, whole.cloth.positions);
  EXPECT_EQ(parts.cloth.velocities, whole.cloth.velocities);
}

// A hand that has some rows of the band where they are, and can accelerate them by so much.
struct HandOnBand {
  HandOnBand(const Band& band, int first_row, int rows, double strength_m_s2)
      : first(band.grid.particle(first_row, 0)),
        weights(band.masses().segment(first, Eigen::Index{rows} * band.grid.across) /
                band.cloth.particle_mass_kg),
        places(band.cloth.positions.middleCols(first, weights.size())),
        most_m_s2(strength_m_s2) {}

  [[nodiscard]] Grip grip() const {
    return {.first = first,
            .weights = {weights.data(), static_cast<std::size_t>(weights.size())},
            .places = Grip::Places(places.data(), 3, places.cols()),
            .drift_m_s = drift_m_s,
            .most_m_s2 = most_m_s2};
  }

  int first;
  Eigen::ArrayXd weights;
  Matrix3Xd places;
  Vector3d drift_m_s = Vector3d::Zero();
  double most_m_s2;
};

void advance_held(Band& band, IntegrationMethod method, double step_s, int steps,
                  const HandOnBand& hand) {
  const Grip grip = hand.grip();
  const auto chosen = band.integrator(method, step_s);
  chosen->take_grips({&grip, 1});
  for (int i = 0; i < steps; ++i) chosen->displace(band.force, band.cloth);
}

// By hand: nine springs one after the other, five side by side, of which each bears what hangs
// below it.
TEST_P(AnyIntegrator, what_a_hand_holds_stays_where_it_is_whatever_hangs_from_it) {
  for (const double step_s : {0.02, 0.0025}) {
    Band band;
    band.stiffness = {.stretch = 20, .damping = 1};
    band.springs = band.springs_of_size(1);
    band.air_resistance_per_s = 2;
    band.gravity_m_s2 = Vector3d(2, 0, 0);
    HandOnBand hand(band, 0, 1, 1e3);
    advance_held(band, GetParam(), step_s, static_cast<int>(15 / step_s), hand);
    EXPECT_LT((band.cloth.positions.leftCols(5) - hand.places).cwiseAbs().maxCoeff(), 2e-4);
    EXPECT_NEAR(band.cloth.positions(0, band.grid.particle(9, 2)), 0.9 + 45 * 0.02 * 2 / 20, 2e-3);
  }
}

TEST_P(AnyIntegrator, what_a_hand_holds_by_its_middle_is_free_to_turn) {
  Band band(200);
  HandOnBand hand(band, 0, band.grid.along, 1e3);
  const Vector3d middle = band.cloth.positions.rowwise().mean();
  hand.places = middle;
  for (int p = 0; p < band.grid.particle_count(); ++p)
    band.cloth.velocities.col(p) = Vector3d(0, 0, 0.5).cross(band.cloth.positions.col(p) - middle);
  band.gravity_m_s2 = Vector3d(0, 3, 0);
  advance_held(band, GetParam(), 0.005, 200, hand);
  EXPECT_LT((band.cloth.positions.rowwise().mean() - middle).norm(), 1e-4);
  const Vector3d along = band.cloth.positions.col(band.grid.particle(9, 2)) -
                         band.cloth.positions.col(band.grid.particle(0, 2));
  EXPECT_NEAR(std::atan2(along.y(), along.x()), 0.5, 0.03);
}

// Not its centre of mass: that is beside it.
TEST_P(AnyIntegrator, the_middle_of_what_a_hand_holds_is_that_of_its_particles) {
  Band band(200);
  band.taper();
  HandOnBand hand(band, 2, 5, 1e3);
  const Eigen::Index first = band.grid.particle(2, 0);
  const Vector3d middle = band.cloth.positions.middleCols(first, 25).rowwise().mean();
  hand.places = middle;
  band.gravity_m_s2 = Vector3d(0, 3, 0);
  band.air_resistance_per_s = 5;
  advance_held(band, GetParam(), 0.005, 400, hand);
  EXPECT_LT((band.cloth.positions.middleCols(first, 25).rowwise().mean() - middle).norm(), 1e-3);
}

TEST_P(AnyIntegrator, what_a_hand_moves_does_not_lag) {
  Band band;
  band.air_resistance_per_s = 5;
  HandOnBand hand(band, 0, band.grid.along, 1e3);
  hand.drift_m_s = Vector3d(0.3, 0, 0.4);
  advance_held(band, GetParam(), 0.01, 100, hand);
  const Matrix3Xd gone = band.cloth.positions - hand.places;
  EXPECT_LT((gone.colwise() - hand.drift_m_s).cwiseAbs().maxCoeff(), 1e-4);
}

// By hand: of an acceleration of 3 it takes 2; the rest goes on, or against the air.
TEST_P(AnyIntegrator, a_hand_that_is_too_weak_gives_way_with_all_its_strength) {
  for (const auto& [stretch, air_per_s] : {std::pair{0.0, 0.0}, {20.0, 0.0}, {0.0, 50.0}}) {
    Band band(stretch);
    band.air_resistance_per_s = air_per_s;
    band.gravity_m_s2 = Vector3d(0, 0, -3);
    HandOnBand hand(band, 0, band.grid.along, 2);
    advance_held(band, GetParam(), 0.01, 100, hand);
    const double wanted_m_s = air_per_s > 0 ? -1 / air_per_s : -1;
    for (const double speed_m_s : band.cloth.velocities.row(2))
      EXPECT_NEAR(speed_m_s / wanted_m_s, 1, 0.03);
  }
}

TEST_P(AnyIntegrator, what_a_hand_holds_comes_back_without_swinging) {
  for (const double step_s : {0.001, 0.01, 0.1}) {
    Band band;
    HandOnBand hand(band, 0, band.grid.along, 1e6);
    band.cloth.positions.row(2).array() += 1;
    double before_m = 1;
    for (int step = 0; step < 40; ++step) {
      advance_held(band, GetParam(), step_s, static_cast<int>(0.1 / step_s), hand);
      const double off_m = band.cloth.positions(2, 0);
      EXPECT_LE(off_m, before_m + 1e-9);
      EXPECT_GE(off_m, -1e-9);
      before_m = off_m;
    }
    EXPECT_NEAR(before_m, 0, 1e-6);
  }
}

TEST(Integrator, explicit_schemes_divide_steps_by_what_is_stable_alone) {
  for (const auto method : {IntegrationMethod::rk4, IntegrationMethod::symplectic_euler}) {
    const auto integrator = Band().integrator(method, 0.01);
    const int stable = integrator->substeps();
    integrator->divide_steps(stable + 1);
    EXPECT_EQ(integrator->substeps(), stable);
  }
}

TEST(Integrator, implicit_opens_a_ribbon_that_lies_in_one_point) {
  Band band(1e6, 1);
  band.cloth.positions.setZero();
  band.crumple(1e-160);  // lengths whose squares are no numbers
  const double start_j = band.energy_j();
  band.advance(IntegrationMethod::implicit, 0.01, 20);
  EXPECT_TRUE(band.cloth.positions.allFinite());
  EXPECT_LE(band.energy_j(), start_j);
}

// A short spring whose ends pass each other resists less and less until they are abreast, and a
// step that ends there has taken the energy from nowhere.
TEST(Integrator, implicit_gains_no_energy_where_a_spring_yields_aside) {
  Band band(0, 1, {3, 1});
  band.springs.bend = {1, {{{2, 0, 1.0}, {0, 2, 1.0}}}};  // between the first and the last particle
  band.cloth.positions.setZero();
  band.cloth.positions.col(2) << 0.1, 0.1, 0;
  band.cloth.velocities(1, 0) = 1;
  band.cloth.velocities(1, 1) = -1;
  EXPECT_LT(energy_in_free_flight(IntegrationMethod::implicit, band, 0.1, 3).highest, 1 + 1e-12);
}

// Both ends of the band are pulled apart, by up to ten million times what doubles its length.
TEST(Integrator, implicit_takes_no_more_energy_from_a_storm_than_it_brings) {
  for (const double air : {0.0, 1e12})
    for (const double pull_n : {1.0, 1e3, 1e9}) {
      Band band(1e4, 1);
      band.air_resistance_per_s = air;
      band.force = Matrix3Xd::Zero(3, band.grid.particle_count());
      band.force.row(0).leftCols(5).setConstant(-pull_n);
      band.force.row(0).rightCols(5).setConstant(pull_n);
      const Matrix3Xd before = band.cloth.positions;
      band.advance(IntegrationMethod::implicit, 0.01, 100);
      const double work_j = band.force.cwiseProduct(band.cloth.positions - before).sum();
      EXPECT_GT(work_j, 0);
      EXPECT_LT(band.energy_j(), work_j);
    }
}

}  // namespace ribbon::integrator_test
