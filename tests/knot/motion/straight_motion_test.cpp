#include "knot/motion/straight_motion.h"

#include <gtest/gtest.h>

#include "geometry/closest_points.h"
#include "knot/knotted_curves.h"

namespace ribbon::straight_motion_test {

Curve edge(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  Curve result(3, 2);
  result << from, to;
  return result;
}

TEST(StraightMotion, an_edge_that_goes_through_another_does_not_stay_clear_of_it) {
  const Curve along_x = edge({-1, 0, 0}, {1, 0, 0});
  const Curve above = edge({0, -1, 1}, {0, 1, 1});
  const auto moved_to = [&](double height, double x) {
    const Curve now = edge({x, -1, height}, {x, 1, height});
    return stay_clear({along_x, along_x}, {above, now});
  };
  EXPECT_TRUE(moved_to(0.01, 0));
  EXPECT_FALSE(moved_to(-0.01, 0));
  EXPECT_FALSE(moved_to(0, 0));       // touches it in the end
  EXPECT_TRUE(moved_to(-1, 3));       // goes down beyond its end
  EXPECT_FALSE(moved_to(-1, 1.5));    // meets it on the way out
  EXPECT_TRUE(moved_to(-0.01, 200));  // far and fast
}

TEST(StraightMotion, edges_that_part_or_slide_past_each_other_stay_clear) {
  const Curve still = edge({0, 0, 0}, {1, 0, 0});
  const Curve near = edge({0, 1e-6, 0}, {1, 1e-6, 0});
  const Curve slid = edge({5, 1e-6, 0}, {6, 1e-6, 0});
  const Curve turned = edge({0.5, 1e-6, 0.5}, {0.5, 1e-6, -0.5});
  EXPECT_TRUE(stay_clear({still, still}, {near, slid}));
  EXPECT_TRUE(stay_clear({still, still}, {near, turned}));
  // Both fly far, together.
  EXPECT_TRUE(stay_clear({still, still.array() + 1e3}, {near, near.array() + 1e3}));
}

Curve random_edge(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Curve::NullaryExpr(3, 2, [&] { return normal(random); });
}

Eigen::Vector3d on_edge(const Curve& edge, double share) {
  return edge.col(0) + share * (edge.col(1) - edge.col(0));
}

// Moved so that a random point of each is at the same place at a random time.
TEST(StraightMotion, edges_that_meet_at_any_time_never_stay_clear) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < 20000; ++round) {
    const Curve one_before = random_edge(random);
    const Curve one_now = random_edge(random);
    Curve other_before = random_edge(random);
    Curve other_now = random_edge(random);
    const double time = share(random);
    const auto at = [&](const Curve& before, const Curve& now) -> Curve {
      return before + time * (now - before);
    };
    const Eigen::Vector3d apart = on_edge(at(one_before, one_now), share(random)) -
                                  on_edge(at(other_before, other_now), share(random));
    other_before.colwise() += apart;
    other_now.colwise() += apart;
    ASSERT_FALSE(stay_clear({one_before, one_now}, {other_before, other_now})) << round;
  }
}

double distance_at(const MovingCurve& one, const MovingCurve& other, double time) {
  const Curve a = one.before + time * (one.now - one.before);
  const Curve b = other.before + time * (other.now - other.before);
  const Eigen::Vector2d closest = closest_on_segments(a.col(0), a.col(1), b.col(0), b.col(1));
  return (on_edge(a, closest[0]) - on_edge(b, closest[1])).norm();
}

// Where 500 instants show that they never come nearer than what they move between two of them.
TEST(StraightMotion, edges_that_do_not_meet_stay_clear) {
  std::mt19937 random(5);
  int clear = 0;
  for (int round = 0; round < 2000; ++round) {
    const Curve one_before = random_edge(random);
    const Curve one_now = random_edge(random);
    const Curve other_before = random_edge(random);
    const Curve other_now = random_edge(random);
    const MovingCurve one{one_before, one_now};
    const MovingCurve other{other_before, other_now};
    const double way = (one_now - one_before).colwise().norm().maxCoeff() +
                       (other_now - other_before).colwise().norm().maxCoeff();
    double nearest = distance_at(one, other, 0);
    for (int k = 1; k <= 500; ++k) nearest = std::min(nearest, distance_at(one, other, k / 500.0));
    if (nearest <= way / 1000) continue;
    ++clear;
    ASSERT_TRUE(stay_clear(one, other)) << round << ", " << nearest << " apart";
  }
  EXPECT_GT(clear, 1000);
}

// Long edges and short ones, so that what is to the left of a curve's edges may reach far over
// them.
Curve random_polygon(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Curve polygon(3, 12);
  for (Eigen::Index k = 0; k < polygon.cols(); ++k)
    for (int axis = 0; axis < 3; ++axis)
      polygon(axis, k) = normal(random) * (k % 4 == 0 ? 10 : 0.3) + 0.5 * static_cast<double>(k);
  return polygon;
}

TEST(StraightMotion, of_curves_is_that_of_all_their_edges) {
  std::mt19937 random(11);
  int clear = 0;
  for (int round = 0; round < 500; ++round) {
    const Curve one = random_polygon(random);
    Curve other = random_polygon(random);
    other.row(1).array() += round % 5;
    const Curve one_now = one + 0.2 * random_polygon(random);
    const Curve other_now = other + 0.2 * random_polygon(random);
    bool all_clear = true;
    for (Eigen::Index i = 0; i + 1 < one.cols(); ++i)
      for (Eigen::Index j = 0; j + 1 < other.cols(); ++j) {
        const Curve a = one.middleCols(i, 2);
        const Curve a_now = one_now.middleCols(i, 2);
        const Curve b = other.middleCols(j, 2);
        const Curve b_now = other_now.middleCols(j, 2);
        all_clear = all_clear && stay_clear({a, a_now}, {b, b_now});
      }
    ASSERT_EQ(stay_clear({one, one_now}, {other, other_now}), all_clear) << round;
    clear += all_clear ? 1 : 0;
  }
  EXPECT_GT(clear, 50);
  EXPECT_LT(clear, 450);
}

TEST(StraightMotion, a_knot_that_is_pulled_stays_clear_of_itself) {
  const Curve before = overhand_knot(300);
  EXPECT_TRUE(stays_clear_of_itself({before, overhand_knot(300, 6.5)}));
  EXPECT_TRUE(stays_clear_of_itself({before, before}));
}

TEST(StraightMotion, a_knot_with_a_strand_passed_through_does_not_stay_clear_of_itself) {
  EXPECT_TRUE(stays_clear_of_itself({overhand_knot(300), overhand_knot_lifted(300, 0.4)}));
  EXPECT_FALSE(stays_clear_of_itself({overhand_knot(300), overhand_knot_lifted(300, 0.6)}));
  EXPECT_FALSE(stays_clear_of_itself({overhand_knot_lifted(300, 2), overhand_knot(300)}));
}

TEST(StraightMotion, edges_next_to_each_other_may_fold) {
  Curve open(3, 3);
  open << 0, 1, 1, 0, 0, 1, 0, 0, 0;
  Curve folded = open;
  folded.col(2) << 0, 0.1, 0;
  EXPECT_TRUE(stays_clear_of_itself({open, folded}));
}

}  // namespace ribbon::straight_motion_test
