#include "simulation/state_archive.h"

#include <bit>
#include <cmath>
#include <utility>

namespace ribbon {

namespace {

constexpr std::size_t bytes_each = 8;

}  // namespace

void StateArchive::visit_bits(std::uint64_t& bits) {
  if (!is_reading_) {
    for (std::size_t i = 0; i < bytes_each; ++i)
      bytes_.push_back(static_cast<char>((bits >> (8 * i)) & 0xFF));
    return;
  }
  if (unread_.size() < bytes_each) refuse("it is cut off");
  if (is_refused()) return;
  bits = 0;
  for (std::size_t i = 0; i < bytes_each; ++i)
    bits |= std::uint64_t{static_cast<unsigned char>(unread_[i])} << (8 * i);
  unread_.remove_prefix(bytes_each);
}

void StateArchive::visit(double& number) {
  auto bits = std::bit_cast<std::uint64_t>(number);
  visit_bits(bits);
  const auto value = std::bit_cast<double>(bits);
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
  if (is_reading_ && !unread_.empty()) refuse("it is longer than what the scene needs");
  if (!is_refused()) return {};
  return failure("", "the state of the simulation does not fit the scene: " + problem_,
                 "take an earlier one, or record the scene anew");
}

}  // namespace ribbon
