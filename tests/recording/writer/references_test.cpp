#include "recording/writer/references.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <vector>

namespace ribbon::references_test {

constexpr std::uint32_t last_count = 4 * compact_group_frames + 3;

TEST(CompactionPlan, has_every_frame_once) {
  for (std::uint32_t frames = 0; frames <= last_count; ++frames) {
    std::set<std::uint32_t> planned;
    for (const PlannedFrame& turn : compaction_plan(frames))
      EXPECT_TRUE(planned.insert(turn.frame).second) << turn.frame << " of " << frames;
    EXPECT_EQ(planned.size(), frames);
    if (frames > 0) {
      EXPECT_EQ(*planned.rbegin(), frames - 1);
    }
  }
}

TEST(CompactionPlan, references_come_earlier_and_lie_around_the_frame) {
  for (std::uint32_t frames = 1; frames <= last_count; ++frames) {
    std::set<std::uint32_t> before;
    for (const PlannedFrame& turn : compaction_plan(frames)) {
      const ReferenceList& references = turn.references;
      for (const std::uint32_t reference : references) EXPECT_TRUE(before.contains(reference));
      if (references.size() > 0) {
        ASSERT_GE(references.size(), 2U);
        EXPECT_LT(references[0], turn.frame);
        EXPECT_GT(references[1], turn.frame);
        for (const std::uint32_t reference : references)
          EXPECT_TRUE(reference <= references[0] || reference >= references[1]);
      }
      before.insert(turn.frame);
    }
  }
}

// The longest way from a frame over references to a key frame.
TEST(CompactionPlan, is_as_deep_as_halving_a_group_takes) {
  for (std::uint32_t frames = 1; frames <= last_count; ++frames) {
    std::map<std::uint32_t, int> depth;
    for (const PlannedFrame& turn : compaction_plan(frames)) {
      int deepest = -1;
      for (const std::uint32_t reference : turn.references)
        deepest = std::max(deepest, depth.at(reference));
      depth[turn.frame] = deepest + 1;
      EXPECT_LE(depth[turn.frame], std::bit_width(compact_group_frames) - 1);
    }
  }
}

// By hand, from FORMAT.md: 1024 frames ahead, 256 others needed.
TEST(CompactionPlan, keeps_the_limits_of_the_format) {
  std::map<std::uint32_t, std::set<std::uint32_t>> needed;
  std::uint32_t before = 0;
  for (const PlannedFrame& turn : compaction_plan(last_count)) {
    EXPECT_GE(before + 1024, turn.frame + 1);
    std::set<std::uint32_t>& others = needed[turn.frame];
    for (const std::uint32_t reference : turn.references) {
      others.insert(reference);
      others.insert(needed[reference].begin(), needed[reference].end());
    }
    EXPECT_LE(others.size(), 2 + compact_group_frames);
    EXPECT_LE(others.size(), 256U);
    ++before;
  }
}

TEST(CompactionPlan, frames_next_to_each_other_are_the_last_step) {
  std::vector<std::uint32_t> turns;
  for (const PlannedFrame& turn : compaction_plan(9)) turns.push_back(turn.frame);
  EXPECT_EQ(turns, (std::vector<std::uint32_t>{0, 8, 4, 2, 6, 1, 3, 5, 7}));
  const ReferenceList last = compaction_plan(9)[6].references;
  EXPECT_EQ(std::vector<std::uint32_t>(last.begin(), last.end()),
            (std::vector<std::uint32_t>{2, 4, 0, 6}));
}

}  // namespace ribbon::references_test
