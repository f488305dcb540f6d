#include "knot/motion/axis_turns.h"

#include <gtest/gtest.h>

#include "knot/knotted_curves.h"

namespace ribbon::axis_turns_test {

const CentreAxis upright_line{{0.5, 0.25, -3}, {0, 0, 1}};
// Within an object that is longer than anything.
const ObjectAxis upright{upright_line, {{-1000, 1000}}};

// About `upright_line`, from angle 0, so that the ends lie on top of each other for whole turns.
Curve coil(double turns) {
  return sampled(100, [turns](double way) {
    const double angle = 2 * std::numbers::pi * turns * way;
    return Eigen::Vector3d(0.5 + 2 * std::cos(angle), 0.25 + 2 * std::sin(angle), way);
  });
}

int turns_of(const Curve& curve, const CentreAxis& line = upright_line) {
  AxisTurns turns({line, upright.inside});
  turns.follow(curve);
  return turns.turns();
}

TEST(AxisTurns, a_coil_goes_round_as_often_as_it_was_wound) {
  EXPECT_EQ(turns_of(coil(1)), 1);
  EXPECT_EQ(turns_of(coil(-1)), -1);
  EXPECT_EQ(turns_of(coil(3)), 3);
  EXPECT_EQ(turns_of(coil(0.2)), 0);
  // The straight line between the ends closes it the shorter way.
  EXPECT_EQ(turns_of(coil(0.8)), 1);
  EXPECT_EQ(turns_of(coil(1.2)), 1);
}

TEST(AxisTurns, against_the_axis_they_are_negative) {
  EXPECT_EQ(turns_of(coil(2), {{0.5, 0.25, 9}, {0, 0, -1}}), -2);
}

TEST(AxisTurns, are_the_same_for_any_slanted_axis) {
  std::mt19937 random(6);
  for (int round = 0; round < 20; ++round) {
    const Eigen::Matrix3d turn = random_rotation(random);
    EXPECT_EQ(
        turns_of(turn * coil(2), {turn * upright_line.point_m, turn * upright_line.direction}), 2);
  }
}

TEST(AxisTurns, stay_when_an_end_travels_round_the_axis) {
  AxisTurns turns(upright);
  for (int step = 0; step <= 100; ++step) {
    turns.follow(coil(1 + 0.03 * step));
    EXPECT_EQ(turns.turns(), 1);
  }
  EXPECT_FALSE(turns.met());
  EXPECT_EQ(turns_of(coil(4)), 4);  // closed without having watched the end
}

TEST(AxisTurns, change_when_the_curve_passes_through) {
  AxisTurns turns(upright);
  turns.follow(coil(1));
  turns.follow(coil(1).colwise() + Eigen::Vector3d(-1.9, 0, 0));
  EXPECT_EQ(turns.turns(), 1);
  // The curve's side passes the axis, the ends (on the other side of it) do not.
  Curve pulled = coil(1);
  for (auto point : pulled.colwise())
    if (point.x() < 0.5) point.x() = 0.6;
  turns.follow(pulled);
  EXPECT_EQ(turns.turns(), 0);
}

TEST(AxisTurns, meeting_the_axis_is_reported) {
  const auto met = [](double x) {
    AxisTurns turns(upright);
    Curve line(3, 3);
    line << x, x, x, -1, 0, 1, 0, 5, 9;
    turns.follow(line);
    return turns.met();
  };
  EXPECT_TRUE(met(0.5));
  EXPECT_FALSE(met(std::nextafter(0.5, 1)));
  EXPECT_FALSE(met(std::nextafter(0.5, 0)));
}

TEST(AxisTurns, a_curve_that_ends_beside_the_axis_does_not_meet_it) {
  // Its line would, farther on.
  AxisTurns turns(upright);
  Curve line(3, 2);
  line << 0.5, 0.5, 1, 2, 0, 0;
  turns.follow(line);
  EXPECT_FALSE(turns.met());
}

// A curve with one turn is pulled sideways until the axis has passed through its side, at height
// 0 of an object that reaches from low_m to high_m.
AxisTurns pulled_through(double low_m, double high_m) {
  AxisTurns turns({{{0.5, 0.25, 0.5}, {0, 0, 1}}, {{low_m, high_m}}});
  for (int tenth = 0; tenth <= 10; ++tenth) {
    Curve curve = coil(1);
    for (auto point : curve.colwise())
      if (point.x() < 0.5) point.x() += 0.3 * tenth;
    turns.follow(curve);
  }
  return turns;
}

TEST(AxisTurns, change_by_what_passes_through_the_object) {
  const AxisTurns turns = pulled_through(-2, 2);
  EXPECT_EQ(turns.turns(), 0);
  EXPECT_EQ(turns.turns_over_ends(), 0);
}

TEST(AxisTurns, what_passes_over_an_end_of_the_object_is_counted_by_itself) {
  for (const auto& [low_m, high_m] : {std::pair(0.2, 5.0), std::pair(-5.0, -0.2)}) {
    const AxisTurns turns = pulled_through(low_m, high_m);
    EXPECT_EQ(turns.turns(), 1);
    EXPECT_EQ(turns.turns_over_ends(), -1);
  }
}

TEST(AxisTurns, what_seems_to_cut_through_the_very_end_has_passed_over_it) {
  EXPECT_EQ(pulled_through(-5, 0.05).turns(), 1);
  EXPECT_EQ(pulled_through(-5, 0.2).turns(), 0);
}

TEST(AxisTurns, meeting_the_axis_beyond_the_object_is_no_fault) {
  AxisTurns turns({upright_line, {{0, 5}}});  // from z = -3 to z = 2
  Curve line(3, 2);
  line << 0.5, 0.5, -1, 1, 4, 4;
  turns.follow(line);
  EXPECT_FALSE(turns.met());
}

}  // namespace ribbon::axis_turns_test
