#include "simulation/state/state_archive.h"

#include <cmath>
#include <utility>

namespace ribbon {

namespace {

// What a number is told from: x from the x before, y from y, z from z.
constexpr std::size_t stride = 3;
constexpr std::size_t bytes_each = 8;

constexpr std::uint64_t most_negative = std::uint64_t{1} << 63;  // its own negative

// Small numbers of both signs to small ones without: the magnitude, and the sign as the lowest bit,
// so that bits which are 0 in all numbers stay so in negative ones.
std::uint64_t folded(std::uint64_t difference) {
  return difference >= most_negative ? (0 - difference) << 1 | 1 : difference << 1;
}
std::uint64_t unfolded(std::uint64_t number) {
  if ((number & 1) == 0) return number >> 1;
  return number == 1 ? most_negative : 0 - (number >> 1);
}

}  // namespace

// Neighbours are alike, and so are the high bytes of their differences.
std::string StateArchive::bytes() const {
  const std::size_t count = numbers_.size();
  std::string planes(bytes_each * count, '\0');
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t number =
        folded(numbers_[i] - (i < stride ? std::uint64_t{0} : numbers_[i - stride]));
    for (std::size_t byte = 0; byte < bytes_each; ++byte)
      planes[byte * count + i] = static_cast<char>(number >> (8 * byte) & 0xFF);
  }
  return planes;
}

StateArchive::StateArchive(std::string_view bytes)
    : is_reading_(true), numbers_(bytes.size() / bytes_each) {
  if (bytes.size() % bytes_each != 0) refuse("it is cut off");
  const std::size_t count = numbers_.size();
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t number = 0;
    for (std::size_t byte = 0; byte < bytes_each; ++byte)
      number |= std::uint64_t{static_cast<unsigned char>(bytes[byte * count + i])} << (8 * byte);
    numbers_[i] = unfolded(number) + (i < stride ? 0 : numbers_[i - stride]);
  }
}

void StateArchive::visit_bits(std::uint64_t& bits) {
  if (!is_reading_) return numbers_.push_back(bits);
  if (next_ == numbers_.size()) refuse("it is cut off");
  if (!is_refused()) bits = numbers_[next_++];
}

void StateArchive::visit(double& number) {
  auto bits = Eigen::numext::bit_cast<std::uint64_t>(number);
  visit_bits(bits);
  const auto value = Eigen::numext::bit_cast<double>(bits);
  if (!is_reading_) return;
  if (!std::isfinite(value)) return refuse("a number in it is not finite");
  number = value;
}

void StateArchive::visit(Eigen::Ref<Eigen::Matrix3Xd> matrix) {
  for (auto column : matrix.colwise())
    for (double& number : column) visit(number);
}

void StateArchive::visit(std::int64_t& number, std::int64_t lowest, std::int64_t highest) {
  auto bits = static_cast<std::uint64_t>(number);
  visit_bits(bits);
  const auto value = static_cast<std::int64_t>(bits);
  if (value < lowest || value > highest) return refuse("a count in it is impossible");
  number = value;
}

void StateArchive::visit(int& number, int lowest, int highest) {
  std::int64_t wide = number;
  visit(wide, lowest, highest);
  number = static_cast<int>(wide);
}

void StateArchive::visit(bool& flag) {
  int number = flag ? 1 : 0;
  visit(number, 0, 1);
  flag = number == 1;
}

void StateArchive::refuse(std::string problem) {
  if (problem_.empty()) problem_ = std::move(problem);
}

Result<void> StateArchive::finish() {
  if (is_reading_ && next_ < numbers_.size()) refuse("it is longer than what the scene needs");
  if (!is_refused()) return {};
  return failure("", "the state of the simulation does not fit the scene: " + problem_,
                 "take an earlier one, or record the scene anew");
}

}  // namespace ribbon
