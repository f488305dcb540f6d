#include "text/json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ribbon::json_test {

TEST(Json, members_keep_the_order_in_which_they_were_named) {
  Json json{{"zebra", 1}, {"apple", Json::list({true, "two", 0.5})}};
  json.set("middle", Json{{"inner", nullptr}});
  EXPECT_EQ(json.text(),
            "{\n  \"zebra\": 1,\n  \"apple\": [\n    true,\n    \"two\",\n    0.5\n  ],\n"
            "  \"middle\": {\n    \"inner\": null\n  }\n}\n");
}

TEST(Json, integers_of_any_size_stay_whole) {
  EXPECT_EQ(Json(-3).text(), "-3\n");
  EXPECT_EQ(Json(std::numeric_limits<std::uint64_t>::max()).text(), "18446744073709551615\n");
  EXPECT_EQ(Json(std::numeric_limits<std::int64_t>::min()).text(), "-9223372036854775808\n");
}

TEST(Json, what_is_not_there_or_no_number_is_null) {
  EXPECT_EQ(Json(std::optional<int>()).text(), "null\n");
  EXPECT_EQ(Json(std::optional<int>(7)).text(), "7\n");
  EXPECT_EQ(Json(std::nan("")).text(), "null\n");
}

TEST(Json, lists_may_be_empty_and_grow) {
  EXPECT_EQ(Json(std::vector<std::string>()).text(), "[]\n");
  Json list(std::vector<int>{1});
  list.add("more");
  EXPECT_EQ(list.text(), "[\n  1,\n  \"more\"\n]\n");
}

TEST(Json, bytes_that_are_no_utf8_are_replaced) {
  EXPECT_EQ(Json("a\xFF").text(), "\"a\xEF\xBF\xBD\"\n");
}

TEST(Json, copies_are_independent) {
  Json first{{"a", 1}};
  const Json second = first;
  first.set("b", 2);
  EXPECT_EQ(second.text(), "{\n  \"a\": 1\n}\n");
}

}  // namespace ribbon::json_test
