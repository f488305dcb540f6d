#include "player/output/manifest.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "result/refusal.h"

namespace ribbon::manifest_test {

namespace fs = std::filesystem;

class Manifests : public TestInFolder {
 protected:
  [[nodiscard]] Manifest opened(const MadeOf& made_of, const Shard& shard = {}) const {
    return Manifest::open(pattern_, made_of, shard).value();
  }
  void write(Manifest& manifest, int number, const std::string& bytes) const {
    ASSERT_TRUE(manifest.note(number, number, bytes));
    ASSERT_TRUE(write_file(pattern_.file(number), bytes));
  }
  [[nodiscard]] std::string text() const { return read_file(file_).value(); }

  const FramePattern pattern_ = FramePattern::parse((folder_ / "{frame:02}.png").string()).value();
  const fs::path file_ = folder_ / "manifest.png.txt";
};

TEST_F(Manifests, know_what_was_written_before) {
  {
    Manifest manifest = opened("a");
    write(manifest, 3, "three");
  }
  const Manifest manifest = opened("a");
  EXPECT_TRUE(manifest.is_complete(3, 3));
  EXPECT_TRUE(manifest.is_known(3));
  EXPECT_FALSE(manifest.is_complete(3, 4)) << "another frame";
  EXPECT_FALSE(manifest.is_complete(4, 4));
  EXPECT_FALSE(manifest.is_known(4));
}

TEST_F(Manifests, believe_no_picture_that_is_not_as_it_was_written) {
  {
    Manifest manifest = opened("a");
    write(manifest, 1, "one");
    write(manifest, 2, "two");
  }
  ASSERT_TRUE(write_file(pattern_.file(1), "One"));
  fs::remove(pattern_.file(2));
  const Manifest manifest = opened("a");
  EXPECT_FALSE(manifest.is_complete(1, 1));
  EXPECT_FALSE(manifest.is_complete(2, 2));
  EXPECT_TRUE(manifest.is_known(1));
}

TEST_F(Manifests, take_what_was_made_of_something_else_for_incomplete_but_known) {
  {
    Manifest manifest = opened("a");
    write(manifest, 1, "one");
  }
  const Manifest manifest = opened("b");
  EXPECT_FALSE(manifest.is_complete(1, 1));
  EXPECT_TRUE(manifest.is_known(1));
  EXPECT_TRUE(opened("a").is_complete(1, 1)) << "and go back";
}

TEST_F(Manifests, of_other_shards_are_read_too) {
  {
    Manifest first = opened("a", {1, 2});
    Manifest second = opened("a", {2, 2});
    write(first, 1, "one");
    write(second, 2, "two");
  }
  EXPECT_TRUE(fs::exists(folder_ / "manifest.png.2of2.txt"));
  const Manifest manifest = opened("a", {1, 3});
  EXPECT_TRUE(manifest.is_complete(1, 1));
  EXPECT_TRUE(manifest.is_complete(2, 2));
}

// A kill may end it anywhere.
TEST_F(Manifests, are_read_at_every_length) {
  {
    Manifest manifest = opened("a");
    write(manifest, 1, "one");
    write(manifest, 2, "two");
  }
  const std::string whole = text();
  for (std::size_t length = 0; length < whole.size(); length += 3) {
    ASSERT_TRUE(write_file(file_, whole.substr(0, length)));
    EXPECT_FALSE(opened("a").is_complete(2, 2)) << length;
    {
      Manifest manifest = opened("a");
      write(manifest, 2, "two");
    }
    EXPECT_TRUE(opened("a").is_complete(2, 2)) << length;
  }
}

TEST_F(Manifests, know_nothing_of_a_name_with_more_or_fewer_digits) {
  Manifest manifest = opened("a");
  write(manifest, 3, "three");
  const auto shorter = FramePattern::parse((folder_ / "{frame:01}.png").string()).value();
  EXPECT_FALSE(Manifest::open(shorter, "a", {}).value().is_known(3));
  EXPECT_TRUE(opened("a").is_known(3));
}

TEST_F(Manifests, believe_no_line_that_somebody_else_wrote) {
  for (const std::string line :
       {"", "picture", "picture 01 of frame", "picture x of frame 1: 3 bytes, checksum 00000000",
        "picture 01 of frame 1: 99999999999999999999999 bytes, checksum 00000000",
        "picture 01 of frame 1: 3 bytes, checksum zz", "made of", "\x89PNG"}) {
    ASSERT_TRUE(write_file(file_, "made of a\n" + line + "\n"));
    EXPECT_FALSE(opened("a").is_known(1)) << line;
  }
}

TEST_F(Manifests, say_where_they_cannot_be_written) {
  fs::create_directory(file_);
  EXPECT_THAT(refusal_of(Manifest::open(pattern_, "a", {})), HasSubstr("manifest.png.txt"));
}

}  // namespace ribbon::manifest_test
