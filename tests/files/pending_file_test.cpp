#include "files/pending_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <filesystem>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "files/watched_disk.h"
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

// A power cut must not leave an empty file under the name.
TEST(PendingFile, is_on_the_disk_before_it_has_its_name) {
  const auto path = temporary_file("synced") / "file.bin";
  for (const auto& [older, takes_its_place] :
       {std::pair(Older::stays, "link file.bin"), {Older::is_replaced, "rename file.bin"}}) {
    const WatchedDisk disk;
    ASSERT_TRUE(write_file(path, "whole", older));
    EXPECT_THAT(disk.calls(), testing::ElementsAre("sync file.bin.part", takes_its_place));
  }
}

TEST(PendingFile, that_may_not_have_reached_the_disk_leaves_the_older_one) {
  const auto path = temporary_file("not synced") / "file.bin";
  ASSERT_TRUE(write_file(path, "older"));
  for (const char* call : {"write", "sync", "close"}) {
    WatchedDisk disk;
    disk.refuse(call, EIO);
    EXPECT_EQ(refusal_of(write_file(path, "newer")),
              path.string() + ": cannot be written (Input/output error); choose another place")
        << call;
    EXPECT_EQ(read_file(path).value(), "older") << call;
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}), 1);
}

TEST(PendingFile, of_a_user_who_may_not_have_more_may_pass_as_on_a_full_disk) {
  WatchedDisk disk;
  disk.refuse("write", EDQUOT, 2);
  const auto written = write_file(temporary_file("quota.bin"), "bytes");
  EXPECT_THAT(refusal_of(written), EndsWith("; free some space or choose another place"));
  EXPECT_TRUE(written.error().may_pass);
}

TEST(PendingFile, is_whole_though_the_system_takes_a_few_bytes_at_a_time) {
  const auto path = temporary_file("few bytes.bin");
  auto file = PendingFile::create(path).value();
  WatchedDisk disk;
  disk.dawdle();
  ASSERT_TRUE(file.append("length ???????????, then the rest"));
  ASSERT_TRUE(file.overwrite(7, "thirty-four"));
  ASSERT_TRUE(file.finish());
  EXPECT_EQ(read_file(path).value(), "length thirty-four, then the rest");
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
