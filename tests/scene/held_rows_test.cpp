#include "scene/held_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace ribbon {

bool operator==(const HeldRows& a, const HeldRows& b) {
  return a.first == b.first && a.last == b.last;
}

namespace held_rows_test {

using testing::ElementsAre;

constexpr int along = 61;

std::vector<HeldRows> rows_of(std::initializer_list<Span> spans) {
  const std::vector<Span> list = spans;
  return held_rows(list, along);
}

TEST(HeldRows, are_those_nearest_to_begin_and_end) {
  EXPECT_THAT(rows_of({{0, 0.02}, {0.5, 0.5}, {0.9, 1}}),
              ElementsAre(HeldRows{0, 1}, HeldRows{30, 30}, HeldRows{54, 60}));
}

TEST(HeldRows, where_spans_meet_the_row_is_that_of_the_one_that_begins_there) {
  EXPECT_THAT(rows_of({{0, 0.5}, {0.5, 1}}), ElementsAre(HeldRows{0, 29}, HeldRows{30, 60}));
  EXPECT_THAT(rows_of({{0.5, 1}, {0, 0.5}}), ElementsAre(HeldRows{30, 60}, HeldRows{0, 29}))
      << "in whatever order they are given";
}

TEST(HeldRows, leave_a_span_the_only_row_that_it_has) {
  EXPECT_THAT(rows_of({{0.5, 0.504}, {0.504, 0.6}}),
              ElementsAre(HeldRows{30, 30}, HeldRows{31, 36}));
}

TEST(HeldRows, are_none_where_there_are_not_enough) {
  EXPECT_EQ(rows_of({{0.5, 0.502}, {0.502, 0.504}})[1].count(), 0);
  EXPECT_LT(rows_of({{0.5, 0.501}, {0.501, 0.502}, {0.502, 0.504}})[2].count(), 1);
}

}  // namespace held_rows_test

}  // namespace ribbon
