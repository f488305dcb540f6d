// What the lint must find, each kind of place once: in a header of ours, in the body that a macro
// opens, and by the analyzer. Never built.
#include "planted.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace ribbon {

int divided_by(int n) {
  if (n == 0) return 1 / n;
  return 1;
}

TEST(Planted, use_after_move) {
  std::string text = "text";
  const std::string taken = std::move(text);
  EXPECT_EQ(taken.size(), text.size());
}

}  // namespace ribbon
