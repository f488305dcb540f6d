#include "converter/export/content_key.h"

#include <gtest/gtest.h>

namespace ribbon::content_key_test {

// From the author's reference implementation.
TEST(ContentKey, it_is_the_hash_that_others_compute) {
  EXPECT_EQ(content_key(""), (ContentKey{0, 0}));
  EXPECT_EQ(content_key("The quick brown fox jumps over the lazy dog"),
            (ContentKey{0xe34bbc7bbc071b6c, 0x7a433ca9c49a9347}));
}

TEST(ContentKey, every_byte_changes_it) {
  const std::string right(37, 'a');
  for (std::size_t i = 0; i < right.size(); ++i) {
    std::string other = right;
    other[i] = 'b';
    EXPECT_NE(content_key(other), content_key(right)) << i;
  }
  EXPECT_NE(content_key(std::string(36, 'a')), content_key(right));
}

}  // namespace ribbon::content_key_test
