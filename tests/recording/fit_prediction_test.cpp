#include "recording/fit_prediction.h"

#include <gtest/gtest.h>

#include <random>

namespace ribbon {
namespace {

// 500 samples whose wanted value is 2 * tap 0 - 0.5 * tap 3.
std::vector<Sample> linear_samples() {
  std::mt19937 random(1);
  std::vector<Sample> samples(500);
  for (Sample& sample : samples) {
    for (auto& tap : sample.taps) tap = static_cast<std::int32_t>(random() % 20001) - 10000;
    sample.wanted = 2 * sample.taps[0] - sample.taps[3] / 2;
  }
  return samples;
}

TEST(FitPrediction, a_linear_rule_is_found) {
  const Predictor predictor = fit_predictor(linear_samples(), std::array{1, 4, 18}, 500).predictor;
  EXPECT_EQ(predictor.taps, 4) << "more taps only cost bytes, fewer do not suffice";
  const double one = std::uint32_t{1} << predictor.shift;
  EXPECT_NEAR(predictor.coefficients[0] / one, 2, 1e-3);
  EXPECT_NEAR(predictor.coefficients[1] / one, 0, 1e-3);
  EXPECT_NEAR(predictor.coefficients[2] / one, 0, 1e-3);
  EXPECT_NEAR(predictor.coefficients[3] / one, -0.5, 1e-3);
}

TEST(FitPrediction, what_cannot_be_predicted_gets_no_taps) {
  std::mt19937 random(2);
  std::vector<Sample> samples = linear_samples();
  for (Sample& sample : samples) sample.wanted = static_cast<std::int32_t>(random() % 1000) - 500;
  EXPECT_EQ(fit_predictor(samples, std::array{1, 18}, 500).predictor.taps, 0);
}

TEST(FitPrediction, taps_that_are_zero_or_equal_do_no_harm) {
  std::vector<Sample> samples = linear_samples();
  for (Sample& sample : samples) {
    sample.taps[1] = 0;
    sample.taps[2] = sample.taps[0];
  }
  const Predictor predictor = fit_predictor(samples, std::array{18}, 100'000).predictor;
  const double one = std::uint32_t{1} << predictor.shift;
  EXPECT_NEAR((predictor.coefficients[0] + predictor.coefficients[2]) / one, 2, 2e-3);
}

TEST(FitPrediction, the_weighted_sum_of_a_fast_ribbon_fits_into_31_bits) {
  std::vector<Sample> samples = linear_samples();
  for (Sample& sample : samples) {
    sample.taps[0] *= 1000;  // up to 10^7
    sample.wanted = 2 * sample.taps[0];
  }
  const Predictor predictor = fit_predictor(samples, std::array{1}, 500).predictor;
  for (const Sample& sample : samples) {
    const std::int32_t predicted =
        rounded_shift(wrapping_product(predictor.coefficients[0], sample.taps[0]), predictor.shift);
    EXPECT_NEAR(predicted, sample.wanted, 1);
  }
}

TEST(FitPrediction, no_samples_give_no_taps) {
  EXPECT_EQ(fit_predictor({}, std::array{1, 18}, 4).predictor.taps, 0);
}

}  // namespace
}  // namespace ribbon
