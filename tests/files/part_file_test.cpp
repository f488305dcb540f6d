#include "files/part_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "files/files.h"
#include "files/temporary_folder.h"

namespace ribbon::part_file_test {

// Processes of two containers, or of two machines on one disk, often have the same number.
TEST(PartFile, two_for_one_name_are_two_files) {
  const auto whole = temporary_file("parts") / "whole.bin";
  auto one = PartFile::create(whole).value();
  auto other = PartFile::create(whole).value();
  EXPECT_NE(one.path(), other.path());
  ASSERT_TRUE(write_all(one.file(), "one"));
  ASSERT_TRUE(write_all(other.file(), "other"));
  ASSERT_TRUE(one.take_place_of(whole).has_value());
  EXPECT_EQ(read_file(whole).value(), "one");
  ASSERT_TRUE(other.take_place_of(whole).has_value());
  EXPECT_EQ(read_file(whole).value(), "other");
}

TEST(PartFile, is_gone_unless_it_has_taken_the_place) {
  const auto whole = temporary_file("given up parts") / "whole.bin";
  EXPECT_TRUE(PartFile::create(whole).has_value());
  EXPECT_TRUE(std::filesystem::is_empty(whole.parent_path()));
}

}  // namespace ribbon::part_file_test
