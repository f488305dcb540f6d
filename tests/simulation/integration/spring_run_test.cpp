#include "simulation/integration/spring_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "parallel/any_instructions.h"

namespace ribbon::spring_run_test {

constexpr long count = 37;  // no whole number of registers

// What springs of many lengths, one of them 0, pull with: x, y and z, then twice the energy or 0.
std::vector<double> tension(bool with_energy) {
  std::vector<double> stiffness(count);
  std::vector<double> start(3 * count);
  std::vector<double> end(3 * count);
  for (int i = 0; i < count; ++i) stiffness[i] = 3 + std::sin(1.0 + i);
  for (int i = 0; i < 3 * count; ++i) {
    start[i] = std::cos(3.0 * i);
    end[i] = i % count == 5 ? start[i] : std::sin(1.0 * i * i);
  }
  std::vector<double> result(4 * count);
  SpringRun run{.count = count,
                .stiffness = stiffness.data(),
                .rest_length_m = 0.7,
                .twice_energy_j = with_energy ? &result[3 * count] : nullptr};
  for (int c = 0; c < 3; ++c) {
    run.starts[c] = &start[c * count];
    run.ends[c] = &end[c * count];
    run.tension[c] = &result[c * count];
  }
  compute_tension(run);
  return result;
}

TEST(SpringRun, all_instruction_sets_give_the_same_bits) {
  same_for_any_instructions([] { return tension(true); });
}

TEST(SpringRun, springs_pull_the_same_where_nobody_asks_for_their_energy) {
  std::vector<double> without_energy = tension(true);
  std::fill(without_energy.begin() + 3 * count, without_energy.end(), 0);
  EXPECT_EQ(tension(false), without_energy);
}

}  // namespace ribbon::spring_run_test
