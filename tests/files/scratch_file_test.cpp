#include "files/scratch_file.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>
#include <string>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "files/watched_disk.h"
#include "result/refusal.h"

namespace ribbon::scratch_file_test {

TEST(ScratchFile, has_no_name_and_comes_out_as_it_went_in) {
  const auto path = temporary_file("scratch") / "whole.bin";
  auto scratch = ScratchFile::create(path).value();
  EXPECT_TRUE(std::filesystem::is_empty(path.parent_path())) << "nothing is left by a kill";
  std::string expected = "front ";
  auto whole = PendingFile::create(path).value();
  ASSERT_TRUE(whole.append(expected));
  for (const std::size_t size : {1U, 70'000U, 3U, 65'536U}) {
    const std::string piece(size, static_cast<char>('a' + expected.size() % 26));
    ASSERT_TRUE(scratch.append(piece));
    expected += piece;
  }
  ASSERT_TRUE(scratch.append_to(whole));
  ASSERT_TRUE(whole.append(" back"));
  ASSERT_TRUE(whole.finish());
  EXPECT_TRUE(read_file(path).value() == expected + " back");
}

TEST(ScratchFile, a_disk_that_takes_no_more_is_told_on_the_way_in_and_out) {
  const auto path = temporary_file("full scratch") / "whole.bin";
  auto scratch = ScratchFile::create(path).value();
  auto whole = PendingFile::create(path).value();
  WatchedDisk disk;
  disk.refuse("write", ENOSPC);
  EXPECT_THAT(refusal_of(scratch.append("lost")),
              testing::StartsWith(path.string() + ": cannot be written"));
  ASSERT_TRUE(scratch.append(std::string(70'000, 'x')));
  disk.refuse("write", ENOSPC);
  EXPECT_THAT(refusal_of(scratch.append_to(whole)),
              testing::StartsWith(path.string() + ": cannot be written"));
}

TEST(ScratchFile, an_unwritable_place_is_named) {
  EXPECT_THAT(refusal_of(ScratchFile::create("/dev/null/knot.usda")),
              testing::HasSubstr("/dev/null"));
}

}  // namespace ribbon::scratch_file_test
