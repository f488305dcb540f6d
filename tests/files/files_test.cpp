#include "files/files.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>

#include "files/temporary_folder.h"
#include "files/watched_disk.h"
#include "recording/size_limit.h"
#include "result/refusal.h"

namespace ribbon::files_test {

TEST(Files, what_was_written_is_read_back) {
  const auto file = temporary_file("new folder") / "bytes.bin";
  const std::string bytes("a\0b\nc", 5);
  ASSERT_TRUE(write_file(file, bytes).has_value());
  EXPECT_EQ(read_file(file).value(), bytes);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1)
      << "a temporary file was left behind";
}

TEST(Files, a_failed_write_leaves_the_older_file_alone) {
  EXPECT_THAT(refusal_of(write_file("/dev/full/never", "x")), HasSubstr("/dev/full"));
  const auto file = temporary_file("too full") / "bytes.bin";
  ASSERT_TRUE(write_file(file, "older").has_value());
  {
    const SizeLimit limit(100'000);
    EXPECT_THAT(refusal_of(write_file(file, std::string(200'000, 'x'))),
                AllOf(StartsWith(file.string() + ": cannot be written"), Not(HasSubstr(".part"))));
  }
  EXPECT_EQ(read_file(file).value(), "older");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1)
      << "a temporary file was left behind";
}

// Another process may have taken it for what a kill has left.
TEST(Files, what_somebody_has_removed_is_written_once_more) {
  const auto file = temporary_file("removed.bin");
  WatchedDisk disk;
  disk.refuse("rename", ENOENT);
  EXPECT_TRUE(write_file(file, "again").has_value());
  EXPECT_EQ(read_file(file).value(), "again");
  disk.refuse("rename", ENOENT, 2);
  EXPECT_THAT(refusal_of(write_file(file, "x")), HasSubstr("was removed by somebody else"));
}

TEST(Files, a_missing_file_is_named) {
  EXPECT_THAT(refusal_of(read_file("/no/such/file")), StartsWith("/no/such/file: "));
}

TEST(Files, a_folder_is_not_a_file) {
  EXPECT_EQ(refusal_of(read_file(testing::TempDir())),
            testing::TempDir() + ": is a folder; name a file");
}

TEST(Files, a_device_that_never_ends_is_not_read) {
  EXPECT_THAT(refusal_of(read_file("/dev/zero")), StartsWith("/dev/zero: is a device"));
}

TEST(Files, no_more_is_read_than_a_file_may_have) {
  const auto file = temporary_file("large.bin");
  ASSERT_TRUE(write_file(file, std::string(1'000'000, 'a')).has_value());
  EXPECT_EQ(read_file(file, 1'000'000)->size(), 1'000'000U);
  std::filesystem::resize_file(file, std::uintmax_t{1} << 35);
  EXPECT_EQ(refusal_of(read_file(file, 1'000'000)),
            file.string() +
                ": is larger than the 1 MB that such a file may have; check that it is "
                "the one that is meant");
  std::filesystem::remove(file);
}

TEST(Files, a_disk_that_cannot_be_read_is_told) {
  EXPECT_THAT(refusal_of(read_file("/proc/self/mem")), HasSubstr(": cannot be read ("));
}

TEST(Files, what_would_be_replaced_is_known) {
  const auto file = temporary_file("taken") / "bytes.bin";
  EXPECT_FALSE(is_taken(file));
  EXPECT_TRUE(is_same_file(file, file.parent_path() / "." / "bytes.bin"));
  EXPECT_TRUE(is_same_file("not-there.bin", "./not-there.bin"));
  ASSERT_TRUE(write_file(file, "x").has_value());
  EXPECT_TRUE(is_taken(file));
  EXPECT_FALSE(is_taken("/dev/null"));
  const auto link = file.parent_path() / "link";
  std::filesystem::create_symlink(file, link);
  EXPECT_TRUE(is_same_file(file, link));
  const auto second_name = file.parent_path() / "second name";
  std::filesystem::create_hard_link(file, second_name);
  EXPECT_TRUE(is_same_file(file, second_name));
  std::filesystem::remove(file);
  EXPECT_TRUE(is_taken(link)) << "it leads nowhere";
  EXPECT_FALSE(is_same_file(file, file.parent_path() / "other.bin"));
}

}  // namespace ribbon::files_test
