#include "files/pending_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "result/refusal.h"

namespace ribbon::pending_file_test {

TEST(PendingFile, pieces_and_corrections_make_the_file) {
  const auto path = temporary_file("pending") / "pieces.bin";
  auto file = PendingFile::create(path).value();
  ASSERT_TRUE(file.append("length ????, "));
  ASSERT_TRUE(file.append("then the rest"));
  ASSERT_TRUE(file.overwrite(7, "0013"));
  EXPECT_EQ(file.size(), 26U);
  EXPECT_FALSE(std::filesystem::exists(path)) << "appears only when it is complete";
  ASSERT_TRUE(file.finish());
  EXPECT_EQ(read_file(path).value(), "length 0013, then the rest");
}

// Some wait in memory, and some are too large for that.
TEST(PendingFile, pieces_of_any_size_stay_in_their_order) {
  const auto path = temporary_file("pending") / "sizes.bin";
  auto file = PendingFile::create(path).value();
  std::string expected;
  for (const std::size_t size : {1U, 70'000U, 3U, 65'530U, 5U, 6U, 65'536U, 2U}) {
    const std::string piece(size, static_cast<char>('a' + expected.size() % 26));
    ASSERT_TRUE(file.append(piece));
    expected += piece;
    ASSERT_EQ(file.size(), expected.size());
  }
  ASSERT_TRUE(file.finish());
  EXPECT_TRUE(read_file(path).value() == expected);
}

TEST(PendingFile, what_is_not_finished_leaves_nothing_behind) {
  const auto path = temporary_file("given up") / "never.bin";
  {
    auto file = PendingFile::create(path).value();
    const PendingFile moved = std::move(file);
    EXPECT_FALSE(std::filesystem::is_empty(path.parent_path()));
  }
  EXPECT_TRUE(std::filesystem::is_empty(path.parent_path()));
}

TEST(PendingFile, an_older_file_stays_until_the_new_one_is_complete) {
  const auto path = temporary_file("replaced") / "file.bin";
  ASSERT_TRUE(write_file(path, "older"));
  {
    auto file = PendingFile::create(path).value();
    ASSERT_TRUE(file.append("newer"));
  }
  EXPECT_EQ(read_file(path).value(), "older");
}

TEST(PendingFile, a_link_goes_on_to_lead_to_the_file) {
  const auto path = temporary_file("behind a link") / "file.bin";
  ASSERT_TRUE(write_file(path, "older"));
  std::filesystem::permissions(path, std::filesystem::perms::owner_read);
  const auto link = temporary_file("link.bin");
  std::filesystem::create_symlink(path, link);
  ASSERT_TRUE(write_file(link, "newer"));
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(read_file(path).value(), "newer");
  EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms::owner_read);
}

// A rename would put a file in their place, and nobody could write to them any more.
TEST(PendingFile, what_is_no_file_is_not_replaced) {
  const auto folder = temporary_file("not a file") / "folder";
  std::filesystem::create_directories(folder);
  EXPECT_THAT(refusal_of(PendingFile::create(folder)), HasSubstr("is a folder"));
  const auto pipe = folder / "pipe.png";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refusal_of(PendingFile::create(pipe)), HasSubstr("choose another name"));
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(PendingFile, an_unwritable_place_is_named) {
  EXPECT_THAT(refusal_of(PendingFile::create("/dev/null/a.bin")), HasSubstr("/dev/null"));
  EXPECT_THAT(refusal_of(PendingFile::create("/proc/a.bin")), EndsWith("); choose another place"))
      << "space is of no use there";
}

}  // namespace ribbon::pending_file_test
