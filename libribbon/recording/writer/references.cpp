#include "recording/writer/references.h"

#include <algorithm>

namespace ribbon {

namespace {

// Coded frames of a group, in time order, with what lies in the middle of them.
class Halving {
 public:
  Halving(std::uint32_t first, std::uint32_t last) : coded_({first, last}) {}

  [[nodiscard]] bool is_done() const { return coded_.back() - coded_.front() + 1 == coded_.size(); }

  // Appends the frames in the middle of gaps to the plan.
  void halve(std::vector<PlannedFrame>& plan) {
    std::vector<std::uint32_t> finer;
    for (std::size_t k = 0; k + 1 < coded_.size(); ++k) {
      finer.push_back(coded_[k]);
      const std::uint32_t gap = coded_[k + 1] - coded_[k];
      if (gap < 2) continue;
      plan.push_back({coded_[k] + gap / 2, references_around(k)});
      finer.push_back(plan.back().frame);
    }
    finer.push_back(coded_.back());
    coded_ = std::move(finer);
  }

 private:
  [[nodiscard]] ReferenceList references_around(std::size_t k) const {
    ReferenceList references;
    references.push_back(coded_[k]);
    references.push_back(coded_[k + 1]);
    if (k > 0) references.push_back(coded_[k - 1]);
    if (k + 2 < coded_.size()) references.push_back(coded_[k + 2]);
    return references;
  }

  std::vector<std::uint32_t> coded_;
};

}  // namespace

ReferenceList live_references(std::uint32_t frame) {
  ReferenceList references;
  const std::uint32_t before = std::min<std::uint32_t>(frame % live_group_frames, 3);
  for (std::uint32_t back = 1; back <= before; ++back) references.push_back(frame - back);
  return references;
}

std::vector<PlannedFrame> compaction_plan(std::uint32_t frames) {
  std::vector<PlannedFrame> plan;
  plan.reserve(frames);
  if (frames > 0) plan.push_back({0});
  for (std::uint32_t first = 0; first + 1 < frames;) {
    const std::uint32_t last = std::min(first + compact_group_frames, frames - 1);
    plan.push_back({last});
    for (Halving group(first, last); !group.is_done();) group.halve(plan);
    first = last;
  }
  return plan;
}

}  // namespace ribbon
