#include "converter/export/unique_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ribbon::unique_names_test {

using testing::ElementsAre;

TEST(UniqueNames, the_later_of_two_gets_a_number) {
  EXPECT_THAT(unique_names({"a", "b"}), ElementsAre("a", "b"));
  EXPECT_THAT(unique_names({"a", "a", "a"}), ElementsAre("a", "a_2", "a_3"));
  EXPECT_THAT(unique_names({"a", "a_2", "a"}), ElementsAre("a", "a_2", "a_3"));
}

}  // namespace ribbon::unique_names_test
