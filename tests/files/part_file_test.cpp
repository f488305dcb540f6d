#include "files/part_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <filesystem>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "files/watched_disk.h"
#include "result/refusal.h"

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

TEST(PartFile, permissions_and_links_outlive_the_older_file) {
  namespace fs = std::filesystem;
  const auto whole = temporary_file("kept") / "whole.bin";
  ASSERT_TRUE(write_file(whole, "older"));
  const auto link = temporary_file("links") / "link.bin";
  fs::create_directories(link.parent_path());
  fs::create_symlink("../kept/whole.bin", link);
  for (const auto only : {fs::perms::owner_read, fs::perms::owner_all | fs::perms::others_read}) {
    fs::permissions(whole, only);
    auto part = PartFile::create(link).value();
    ASSERT_TRUE(write_all(part.file(), "newer"));
    EXPECT_EQ(part.path().parent_path(), fs::canonical(whole.parent_path()));
    ASSERT_TRUE(part.take_place_of(link).has_value());
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(read_file(whole).value(), "newer");
    EXPECT_EQ(fs::status(whole).permissions(), only);
  }
}

TEST(PartFile, that_somebody_has_removed_may_be_written_again) {
  const auto whole = temporary_file("removed") / "whole.bin";
  auto part = PartFile::create(whole).value();
  std::filesystem::remove(part.path());
  const auto taken = part.take_place_of(whole);
  EXPECT_THAT(refusal_of(taken), HasSubstr("was removed by somebody else while it was written"));
  EXPECT_TRUE(taken.error().may_pass);
}

TEST(PartFile, takes_no_place_where_something_came_meanwhile_and_stays_itself) {
  const auto whole = temporary_file("came meanwhile") / "whole.bin";
  auto part = PartFile::create(whole).value();
  ASSERT_TRUE(write_all(part.file(), "mine"));
  const auto path = part.path();
  ASSERT_TRUE(write_file(whole, "somebody else's"));
  EXPECT_THAT(refusal_of(part.take_place_of(whole, Older::stays)),
              AllOf(StartsWith(whole.string()), HasSubstr("complete as " + path.string())));
  part = PartFile::create(whole).value();
  EXPECT_EQ(read_file(whole).value(), "somebody else's");
  EXPECT_EQ(read_file(path).value(), "mine");
  std::filesystem::remove(whole);
  ASSERT_TRUE(write_all(part.file(), "the next"));
  ASSERT_TRUE(part.take_place_of(whole, Older::stays).has_value());
  EXPECT_EQ(read_file(whole).value(), "the next");
  std::filesystem::remove(path);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(whole.parent_path()), {}), 1);
}

// As those of memory cards.
TEST(PartFile, takes_only_a_free_place_on_file_systems_that_know_no_second_names_either) {
  const auto whole = temporary_file("one name each") / "whole.bin";
  WatchedDisk disk;
  disk.refuse("link", EPERM, 2);
  ASSERT_TRUE(PartFile::create(whole)->take_place_of(whole, Older::stays).has_value());
  ASSERT_TRUE(write_file(whole, "somebody else's"));
  EXPECT_THAT(refusal_of(PartFile::create(whole)->take_place_of(whole, Older::stays)),
              HasSubstr("was put there by somebody else meanwhile"));
  EXPECT_EQ(read_file(whole).value(), "somebody else's");
}

// Nothing could be lost in it, but somebody reads from it.
TEST(PartFile, takes_no_place_where_a_pipe_came_meanwhile) {
  const auto whole = temporary_file("a pipe came") / "whole.bin";
  auto part = PartFile::create(whole).value();
  ASSERT_EQ(::mkfifo(whole.c_str(), 0600), 0);
  EXPECT_FALSE(part.take_place_of(whole, Older::stays).has_value());
  EXPECT_TRUE(std::filesystem::is_fifo(whole));
}

TEST(PartFile, of_no_other_file_is_taken_for_what_a_kill_has_left) {
  namespace fs = std::filesystem;
  const auto folder = temporary_file("left.part 1");
  const auto linked = temporary_file("left by links");
  const std::vector<std::string> others = {"a.obj",        "a.obj.part", "a.obj.partial",
                                           "a.obj.part1b", "a.obj.1",    "b.obj.part1"};
  for (const std::string& name : others) ASSERT_TRUE(write_file(folder / name, name));
  for (const auto& left : {folder / "a.obj.part12", linked / "c.obj.part0"})
    ASSERT_TRUE(write_file(left, "left"));
  fs::create_symlink(linked / "c.obj", folder / "link.obj");
  ASSERT_TRUE(write_file(linked / "c.obj", "whole"));
  remove_leftovers({folder / "a.obj", folder / "link.obj"});
  for (const std::string& name : others) EXPECT_TRUE(fs::exists(folder / name)) << name;
  EXPECT_FALSE(fs::exists(folder / "a.obj.part12"));
  EXPECT_FALSE(fs::exists(linked / "c.obj.part0"));
  EXPECT_TRUE(fs::exists(linked / "c.obj"));
}

TEST(PartFile, the_folder_that_is_synced_is_that_of_the_file_itself) {
  const auto whole = temporary_file("synced folder") / "whole.bin";
  const auto link = temporary_file("other folder") / "link.bin";
  ASSERT_TRUE(write_file(whole, "whole") && create_folder_of(link));
  std::filesystem::create_symlink(whole, link);
  const WatchedDisk disk;
  sync_folder_of(link);
  EXPECT_THAT(disk.calls(), testing::ElementsAre("sync synced folder"));
}

TEST(PartFile, is_refused_under_the_name_of_a_folder_which_is_not_created) {
  const auto folder = temporary_file("named folder");
  for (const std::string end : {"/", "/.", "/a/.."})
    EXPECT_THAT(refusal_of(PartFile::create(folder.string() + end)),
                HasSubstr("is the name of a folder, not of a file; name a file in it"));
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(PartFile, a_link_that_leads_nowhere_makes_way) {
  const auto link = temporary_file("nowhere.bin");
  std::filesystem::create_symlink("gone/whole.bin", link);
  ASSERT_TRUE(PartFile::create(link).value().take_place_of(link).has_value());
  EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(link)));
}

}  // namespace ribbon::part_file_test
