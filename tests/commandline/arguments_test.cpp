#include "commandline/arguments.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>

#include "result/refusal.h"

namespace ribbon::arguments_test {

// What a tool with a number from 0.01 to 100 says to it.
Result<double> read_number(const char* text) {
  double number = 0;
  Arguments arguments("ribbon-test", "", "0", "");
  arguments.add("--noise", number, {0.01, 100}, "X", "");
  const std::array<const char*, 3> words = {"ribbon-test", "--noise", text};
  return arguments.parse(3, words.data()).map([&](bool) { return number; });
}

TEST(Arguments, numbers_lie_within_their_limits_both_included) {
  EXPECT_EQ(read_number("0.01").value(), 0.01);
  EXPECT_EQ(read_number("1e2").value(), 100);
  for (const char* text : {"0.009", "101", "-1", "inf", "two", "3x", ""})
    EXPECT_THAT(refusal_of(read_number(text)), HasSubstr("--noise")) << text;
}

TEST(Arguments, what_is_no_number_lies_within_no_limits) {
  for (const char* text : {"nan", "-nan", "NaN"})
    EXPECT_EQ(refusal_of(read_number(text)), "--noise: '" + std::string(text) +
                                                 "' is not a number from 0.01 to 100; see "
                                                 "ribbon-test --help");
}

TEST(Arguments, an_empty_value_is_refused_with_its_option) {
  std::string text;
  std::filesystem::path file;
  std::vector<std::string> texts;
  std::pair<std::string, std::string> pair;
  Arguments arguments("ribbon-test", "", "0", "");
  arguments.add("--frames", text, "VALUE", "");
  arguments.add("-o,--output", file, "VALUE", "");
  arguments.add("--set", texts, "VALUE", "");
  arguments.add("--between", pair, "VALUE", "");
  for (const char* option : {"--frames", "--output", "--set", "--between"}) {
    const std::array<const char*, 4> words = {"ribbon-test", option, "", "b"};
    const int count = option == std::string("--between") ? 4 : 3;
    EXPECT_EQ(refusal_of(arguments.parse(count, words.data())),
              option + std::string(": is followed by an empty text; write ") + "VALUE" +
                  " behind it, or leave it out");
  }
}

}  // namespace ribbon::arguments_test
