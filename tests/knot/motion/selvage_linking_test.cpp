#include "knot/motion/selvage_linking.h"

#include <gtest/gtest.h>

#include "knot/knotted_curves.h"

namespace ribbon::selvage_linking_test {

const SelvageLinking::Directions along_x{Eigen::Vector3d(-1, 0.02, 0.01),
                                         Eigen::Vector3d(1, 0.03, -0.02)};

RibbonCurves curves_of(const Curve& curve, double turns,
                       const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ()) {
  return ribbon_curves({static_cast<int>(curve.cols()), 4}, ribbon_along(curve, 4, 0.2, turns, up));
}

Curve straight() {
  return sampled(60, [](double way) { return Eigen::Vector3d(6 * way, 0, 0); });
}

std::optional<int> linking_of(const RibbonCurves& curves) {
  SelvageLinking linking;
  linking.start(curves, along_x);
  return linking.number();
}

TEST(SelvageLinking, of_a_straight_ribbon_is_the_number_of_full_turns) {
  for (int turns = -3; turns <= 3; ++turns)
    EXPECT_EQ(linking_of(curves_of(straight(), turns)), turns);
}

TEST(SelvageLinking, half_a_turn_is_made_whole_right_handed) {
  EXPECT_EQ(linking_of(curves_of(straight(), 0.5)), 1);
  EXPECT_EQ(linking_of(curves_of(straight(), -0.5)), 0);
  EXPECT_EQ(linking_of(curves_of(straight(), 1.5)), 2);
}

TEST(SelvageLinking, of_a_flat_knot_is_its_writhe) {
  EXPECT_EQ(linking_of(curves_of(overhand_knot(300), 0)), 3);
  EXPECT_EQ(linking_of(curves_of(overhand_knot(300, 6, -1), 0)), -3);
  EXPECT_EQ(linking_of(curves_of(overhand_knot(300), -3)), 0);
}

// Turns the last fifth of the ribbon about x, more and more towards its end.
RibbonCurves with_end_turned(double full_turns) {
  const Curve line = straight();
  Eigen::Matrix3Xf positions = ribbon_along(line, 4, 0.2, 1);
  for (auto point : positions.colwise()) {
    const double share = std::clamp((point.x() - 4.8) / 1.2, 0.0, 1.0);
    const Eigen::AngleAxisd turn(2 * std::numbers::pi * full_turns * share,
                                 Eigen::Vector3d::UnitX());
    point = (turn * point.cast<double>()).cast<float>();
  }
  return ribbon_curves({static_cast<int>(line.cols()), 4}, positions);
}

TEST(SelvageLinking, stays_when_an_end_is_turned) {
  for (const double sense : {1.0, -1.0}) {
    SelvageLinking linking;
    RibbonCurves before = with_end_turned(0);
    linking.start(before, along_x);
    for (int step = 1; step <= 30; ++step) {
      RibbonCurves now = with_end_turned(sense * step / 10);
      linking.follow(before, now, along_x);
      EXPECT_EQ(linking.number(), 1) << "step " << step;
      before = std::move(now);
    }
    EXPECT_EQ(linking_of(before), 1 + 3 * sense);  // without having watched the end
  }
}

// By hand: of steps by six tenths of a turn each is taken for one by four tenths the other way.
TEST(SelvageLinking, counts_turns_that_may_have_gone_the_other_way) {
  struct Case {
    double turns_a_step;
    int wide_turns;
    int number;
  };
  for (const auto& [turns_a_step, wide_turns, number] :
       {Case{0.2, 0, 1}, Case{-0.2, 0, 1}, Case{0.3, 5, 1}, Case{0.6, 5, 6}, Case{-0.6, 5, -4}}) {
    SelvageLinking linking;
    RibbonCurves before = with_end_turned(0);
    linking.start(before, along_x);
    for (int step = 1; step <= 5; ++step) {
      RibbonCurves now = with_end_turned(turns_a_step * step);
      linking.follow(before, now, along_x);
      before = std::move(now);
    }
    EXPECT_EQ(linking.wide_turns(), wide_turns) << turns_a_step;
    EXPECT_EQ(linking.number(), number) << turns_a_step;
  }
}

// By hand: nine tenths of a turn are taken for one tenth the other way.
TEST(SelvageLinking, counts_steps_in_which_an_end_goes_so_far_that_it_may_have_turned_any_way) {
  for (const auto& [across_m, wide_turns] : {std::pair(0.1, 0), {0.7, 2}}) {
    SelvageLinking linking;
    const RibbonCurves before = with_end_turned(0);
    RibbonCurves now = with_end_turned(0.9);
    for (Eigen::Matrix3Xd* curve : {&now.centre_line, &now.first_selvage, &now.second_selvage})
      curve->row(1).array() += across_m;
    linking.start(before, along_x);
    linking.follow(before, now, along_x);
    EXPECT_EQ(linking.wide_turns(), wide_turns) << "the ribbon is 0.6 m wide";
    EXPECT_EQ(linking.number(), 2);
  }
}

TEST(SelvageLinking, stays_when_the_first_end_is_turned_too) {
  const auto reversed = [](RibbonCurves curves) {
    curves.first_selvage = curves.first_selvage.rowwise().reverse().eval();
    curves.second_selvage = curves.second_selvage.rowwise().reverse().eval();
    return curves;
  };
  const SelvageLinking::Directions rays{along_x[1], along_x[0]};
  SelvageLinking linking;
  RibbonCurves before = reversed(with_end_turned(0));
  linking.start(before, rays);
  for (int step = 1; step <= 30; ++step) {
    RibbonCurves now = reversed(with_end_turned(0.1 * step));
    linking.follow(before, now, rays);
    before = std::move(now);
  }
  EXPECT_EQ(linking.number(), 1);
}

TEST(SelvageLinking, stays_when_the_rays_turn) {
  SelvageLinking linking;
  const RibbonCurves still = curves_of(overhand_knot(300), 2);
  linking.start(still, along_x);
  for (const double x : {-1.0, -0.1, 1.0}) {  // in the end, over the whole knot
    linking.follow(still, still, {Eigen::Vector3d(x, 0.01, 1.5), Eigen::Vector3d(-x, 0.2, 1.5)});
    EXPECT_EQ(linking.number(), 5);
  }
}

TEST(SelvageLinking, stays_when_the_ribbon_turns_below_a_ray) {
  const SelvageLinking::Directions rays{Eigen::Vector3d(-1, 0.02, 0.5),
                                        Eigen::Vector3d(0.1, 0.2, -1)};
  const auto turned = [](int step) {
    const Eigen::AngleAxisd turn(std::numbers::pi * step / 20, Eigen::Vector3d::UnitZ());
    return curves_of(turn.toRotationMatrix() * straight(), 1);
  };
  for (const int sense : {1, -1}) {
    SelvageLinking linking;
    linking.start(turned(0), rays);
    for (int step = 1; step <= 22; ++step) {
      linking.follow(turned(sense * (step - 1)), turned(sense * step), rays);
      EXPECT_EQ(linking.number(), 1) << "step " << step;
    }
  }
}

TEST(SelvageLinking, changes_by_two_when_the_ribbon_passes_through_itself) {
  SelvageLinking linking;
  const RibbonCurves right = curves_of(overhand_knot(300), 0);
  linking.start(right, along_x);
  linking.follow(right, curves_of(overhand_knot_lifted(300, 2), 0), along_x);
  EXPECT_EQ(linking.number(), 1);
}

TEST(SelvageLinking, touching_selvages_have_none) {
  RibbonCurves curves = curves_of(straight(), 0);
  curves.second_selvage = curves.first_selvage;
  EXPECT_FALSE(linking_of(curves));
}

}  // namespace ribbon::selvage_linking_test
