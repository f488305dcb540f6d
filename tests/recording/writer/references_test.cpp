#include "recording/writer/references.h"

#include <gtest/gtest.h>

#include <vector>

namespace ribbon::references_test {

std::vector<std::uint32_t> listed(std::uint32_t frame) {
  const ReferenceList references = references_of(frame);
  return {references.begin(), references.end()};
}

TEST(References, are_the_two_frames_before) {
  EXPECT_EQ(listed(group_frames + 7),
            (std::vector<std::uint32_t>{group_frames + 6, group_frames + 5}));
}

TEST(References, do_not_leave_the_group) {
  EXPECT_TRUE(listed(0).empty());
  EXPECT_EQ(listed(1), std::vector<std::uint32_t>{0});
  EXPECT_EQ(listed(group_frames - 1).size(), 2U);
  EXPECT_TRUE(listed(group_frames).empty());
  EXPECT_EQ(listed(group_frames + 1), std::vector<std::uint32_t>{group_frames});
}

}  // namespace ribbon::references_test
