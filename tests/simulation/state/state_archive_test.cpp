#include "simulation/state/state_archive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ribbon::state_archive_test {

std::string bytes_of(std::vector<double> numbers) {
  StateArchive archive;
  for (double& number : numbers) archive.visit(number);
  return archive.bytes();
}

// Zeros of both signs are as far apart as bits can be.
TEST(StateArchive, reads_what_it_wrote_however_far_apart_numbers_are) {
  const double largest = std::numeric_limits<double>::max();
  const double smallest = std::numeric_limits<double>::denorm_min();
  std::vector<double> numbers;
  for (const double a : {0.0, -0.0, 1.0, -1.0, largest, -largest, smallest, -smallest})
    for (const double b : {0.0, -0.0, 0.1, -0.1, largest, -largest, smallest, -smallest})
      numbers.insert(numbers.end(), {a, a, a, b, b, b});
  StateArchive archive(bytes_of(numbers));
  for (const double number : numbers) {
    double read = 7;
    archive.visit(read);
    EXPECT_EQ(read, number);
    EXPECT_EQ(std::signbit(read), std::signbit(number));
  }
  EXPECT_TRUE(archive.finish().has_value());
}

// Else negative differences of numbers with few digits would have their sign in every byte.
TEST(StateArchive, keeps_bytes_zero_that_are_zero_in_all_numbers) {
  const std::vector<double> numbers{1, 2, 3, 0.5, 4, -3, 8, -0.25, 0.125, 16, 1, -2};
  const std::string bytes = bytes_of(numbers);
  const std::size_t count = numbers.size();
  for (std::size_t i = 0; i < 6 * count; ++i)
    EXPECT_LE(static_cast<unsigned char>(bytes[i]), i < count ? 1 : 0) << i;
}

}  // namespace ribbon::state_archive_test
