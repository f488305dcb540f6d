// The state of a simulation as bytes, in full precision (STATE.md).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "result/result.h"

namespace ribbon {

// Who has state that outlives a step visits it in one function, which serves both directions: an
// archive that writes collects what is visited, one that reads overwrites it. Those functions bind
// all members of their class by name, so that one more does not compile until somebody has decided
// whether it is state.
//
// Sizes are never read: who is visited knows them. What cannot be read, or is not possible, is
// noted; the rest of the visit then changes nothing, and finish() tells.
class StateArchive {
 public:
  // Writes.
  StateArchive() = default;
  // Reads what bytes() gave.
  explicit StateArchive(std::string_view bytes);

  [[nodiscard]] bool is_reading() const { return is_reading_; }

  // Finite.
  void visit(double& number);
  // 3 x as many columns as there are, all finite.
  void visit(Eigen::Ref<Eigen::Matrix3Xd> matrix);
  // From lowest to highest.
  void visit(std::int64_t& number, std::int64_t lowest, std::int64_t highest);
  void visit(int& number, int lowest, int highest);
  void visit(bool& flag);

  // Notes, unless something was noted before, why the state cannot be.
  void refuse(std::string problem);
  [[nodiscard]] bool is_refused() const { return !problem_.empty(); }

  // Reading: what follows is not wanted.
  void ignore_rest() { next_ = numbers_.size(); }

  // Reading: was there anything to refuse, or anything left over?
  [[nodiscard]] Result<void> finish();
  // Writing: what was visited, in an order that lets it be compressed.
  [[nodiscard]] std::string bytes() const;

 private:
  void visit_bits(std::uint64_t& bits);

  bool is_reading_ = false;
  std::vector<std::uint64_t> numbers_;
  std::size_t next_ = 0;  // to be read
  std::string problem_;
};

}  // namespace ribbon
