#include "knot/knot_witness.h"

#include <gtest/gtest.h>

#include <limits>

#include "knot/knotted_curves.h"

namespace ribbon::knot_witness_test {

constexpr int across = 6;
constexpr double width = 0.2;
// Through the overhand knot's loop.
const ObjectAxis axis{{{0, -1, 0}, {0, 0, 1}}, {{-100, 100}}};

RibbonGrid grid_of(const Curve& curve) {
  return {static_cast<int>(curve.cols()), across};
}

KnotCertificate certificate_of(const Curve& curve, double turns = 0) {
  KnotWitness witness(grid_of(curve), axis);
  witness.follow(ribbon_along(curve, across, width, turns));
  return witness.certificate();
}

TEST(KnotWitness, certifies_an_overhand_knot) {
  EXPECT_EQ(certificate_of(overhand_knot(300)).text(),
            "trefoil, right-handed (3 crossings); 2 turns round the object; "
            "selvages linked 3 times");
  EXPECT_EQ(certificate_of(overhand_knot(300, 6, -1), 1).text(),
            "trefoil, left-handed (3 crossings); 2 turns round the object; "
            "selvages linked -2 times");
}

TEST(KnotWitness, does_not_mind_how_finely_the_ribbon_is_divided) {
  const KnotCertificate coarse = certificate_of(overhand_knot(120), 1);
  EXPECT_EQ(certificate_of(overhand_knot(240), 1), coarse);
  EXPECT_EQ(certificate_of(overhand_knot(601), 1), coarse);
}

TEST(KnotWitness, does_not_mind_how_many_columns_there_are) {
  const Curve knot = overhand_knot(200);
  const KnotCertificate expected = certificate_of(knot);
  for (const int columns : {2, 3, 7, 8}) {
    KnotWitness witness({200, columns}, axis);
    witness.follow(ribbon_along(knot, columns, width));
    EXPECT_EQ(witness.certificate(), expected);
  }
}

// Positions of a witness's frames along a motion; the certificate after each.
std::vector<KnotCertificate> followed(int steps,
                                      const std::function<Eigen::Matrix3Xf(double)>& motion,
                                      const RibbonGrid& grid) {
  KnotWitness witness(grid, axis);
  std::vector<KnotCertificate> result;
  for (int step = 0; step <= steps; ++step) {
    witness.follow(motion(static_cast<double>(step) / steps));
    result.push_back(witness.certificate());
  }
  return result;
}

void expect_constant(const std::vector<KnotCertificate>& certificates) {
  for (std::size_t k = 1; k < certificates.size(); ++k)
    ASSERT_EQ(certificates[k], certificates[0])
        << "frame " << k << ": " << certificates[k].text() << ", not " << certificates[0].text();
}

TEST(KnotWitness, travelling_ends_change_nothing) {
  const auto pulled = [](double time) {
    return ribbon_along(overhand_knot(200, 6 + 10 * time), across, width);
  };
  expect_constant(followed(30, pulled, {200, across}));
}

TEST(KnotWitness, a_turning_knot_stays_what_it_is) {
  // Three turns about slanted lines through the knot. The rays have to give way to the ribbon again
  // and again; the axis is left out because the ribbon passes through it.
  std::mt19937 random(7);
  for (int round = 0; round < 3; ++round) {
    const Eigen::Vector3d line = random_rotation(random).col(0);
    const Eigen::Matrix3Xd knot = ribbon_along(overhand_knot(150), across, width, 1).cast<double>();
    KnotWitness witness({150, across}, {});
    std::optional<KnotCertificate> first;
    for (int step = 0; step <= 60; ++step) {
      const Eigen::AngleAxisd turn(2 * std::numbers::pi * step / 60, line);
      witness.follow((turn.toRotationMatrix() * knot).cast<float>());
      if (!first) first = witness.certificate();
      ASSERT_EQ(witness.certificate(), *first) << "step " << step;
    }
  }
}

TEST(KnotWitness, an_end_carried_round_the_knot_changes_nothing) {
  // The last tenth of the ribbon swings once round the line of the knot, in front of it and behind
  // it, and the ribbon's rays and its turns are followed.
  const Curve knot = overhand_knot(300);
  const auto swung = [&](double time) {
    Curve curve = knot;
    const Eigen::Vector3d joint(6, knot(1, 299), knot(2, 299));
    const double angle = 2 * std::numbers::pi * time;
    for (Eigen::Index k = 0; k < curve.cols(); ++k) {
      const double out = std::max(0.0, knot(0, k) - 4.0);
      curve.col(k) +=
          Eigen::Vector3d(0, 0.7 * out * std::sin(angle), 0.7 * out * (1 - std::cos(angle)));
    }
    return ribbon_along(curve, across, width);
  };
  expect_constant(followed(40, swung, {300, across}));
}

TEST(KnotWitness, an_end_drawn_back_into_the_knot_never_turns_it_into_another) {
  // The last end slips back along the knot until it is untied. Its ray stays where it was led
  // through, so the knot stays a trefoil for as long as there is such a ray; it never becomes
  // something else.
  const Curve whole = overhand_knot(461);
  KnotWitness witness({200, across}, {});
  int step = 0;
  for (; step <= 80; ++step) {
    const double rest = 1 - 0.004 * step;
    const Curve drawn_back = sampled(200, [&](double way) {
      return Eigen::Vector3d(whole.col(static_cast<Eigen::Index>(std::lround(460 * rest * way))));
    });
    witness.follow(ribbon_along(drawn_back, across, 0.05));
    const KnotCertificate certificate = witness.certificate();
    if (certificate.last_end_buried) break;
    ASSERT_TRUE(certificate.jones);
    EXPECT_EQ(certificate.jones->text(), "t + t^3 - t^4") << "step " << step;
    EXPECT_EQ(certificate.selvage_linking, 3) << "step " << step;
  }
  EXPECT_GT(step, 20) << "before the end is buried";
}

TEST(KnotWitness, a_strand_passed_through_another_is_found) {
  const auto lifted = [](double time) {
    return ribbon_along(overhand_knot_lifted(300, 2 * time), across, width);
  };
  const auto certificates = followed(10, lifted, {300, across});
  EXPECT_EQ(certificates.back().text(), "unknot; 2 turns round the object; selvages linked 1 time");
}

TEST(KnotWitness, a_ribbon_pulled_through_the_axis_is_found) {
  const auto shifted = [](double time) {
    Curve curve = overhand_knot(200);
    curve.row(1).array() += 6 * time;
    return ribbon_along(curve, across, width);
  };
  const auto certificates = followed(20, shifted, {200, across});
  EXPECT_NE(certificates.back().turns_round_object, certificates.front().turns_round_object);
  EXPECT_EQ(certificates.back().jones, certificates.front().jones);
}

TEST(KnotWitness, a_broken_frame_is_said_and_remembered) {
  KnotWitness witness({200, across}, axis);
  Eigen::Matrix3Xf positions = ribbon_along(overhand_knot(200), across, width);
  witness.follow(positions);
  EXPECT_FALSE(witness.certificate().broken_positions);
  Eigen::Matrix3Xf broken = positions;
  broken(1, 77) = std::numeric_limits<float>::quiet_NaN();
  witness.follow(broken);
  EXPECT_TRUE(witness.certificate().broken_positions);
  witness.follow(positions);
  EXPECT_TRUE(witness.certificate().broken_positions);
}

Eigen::Matrix3Xf ball(double hole_rad, double windings = 60) {
  return ribbon_along(ball_with_hole(hole_rad, windings), 2, 0.01);
}

KnotWitness of_an_end_that_gets_buried(const Eigen::Matrix3Xf& frame_after_that) {
  KnotWitness witness({700, 2}, {});
  for (const double hole_rad : {0.6, 0.58, 0.3, 0.1, 0.02}) witness.follow(ball(hole_rad));
  witness.follow(frame_after_that);
  return witness;
}

TEST(KnotWitness, what_a_buried_end_leaves_unknown_is_carried_on_by_straight_motion) {
  const KnotWitness witness = of_an_end_that_gets_buried(ball(0.03));
  const KnotCertificate certificate = witness.certificate();
  EXPECT_TRUE(certificate.first_end_buried);
  EXPECT_FALSE(certificate.is_known());
  EXPECT_TRUE(certificate.is_carried_on());
  ASSERT_TRUE(witness.last_closed());
  EXPECT_TRUE(witness.last_closed()->is_known());
  KnotWitness at_first({700, 2}, {});
  at_first.follow(ball(0.6));
  EXPECT_EQ(*witness.last_closed(), at_first.certificate());
}

TEST(KnotWitness, what_may_have_passed_meanwhile_is_not_carried_on) {
  const KnotCertificate certificate = of_an_end_that_gets_buried(ball(0.02, 50)).certificate();
  EXPECT_TRUE(certificate.first_end_buried);
  EXPECT_TRUE(certificate.may_have_passed);
  EXPECT_FALSE(certificate.is_carried_on());
}

TEST(KnotWitness, particles_all_in_one_place_are_certified_as_unknown) {
  KnotWitness witness({20, across}, axis);
  witness.follow(Eigen::Matrix3Xf::Zero(3, RibbonGrid{20, across}.particle_count()));
  EXPECT_TRUE(witness.certificate().first_end_buried);
  EXPECT_FALSE(witness.certificate().is_known());
  EXPECT_FALSE(witness.certificate().jones);
}

TEST(KnotWitness, size_and_place_do_not_matter) {
  const Eigen::Matrix3Xf knot = ribbon_along(overhand_knot(200), across, width);
  const auto certificate_at = [&](float scale, float shift) {
    KnotWitness witness({200, across}, {});
    witness.follow((knot * scale).array() + shift);
    return witness.certificate();
  };
  const KnotCertificate expected = certificate_at(1, 0);
  EXPECT_EQ(certificate_at(1e-4F, 0), expected);
  EXPECT_EQ(certificate_at(1e3F, 0), expected);
  EXPECT_EQ(certificate_at(1e-30F, 0), expected);
  EXPECT_EQ(certificate_at(1e30F, 0), expected);
  EXPECT_EQ(certificate_at(1, 1000), expected);
}

}  // namespace ribbon::knot_witness_test
