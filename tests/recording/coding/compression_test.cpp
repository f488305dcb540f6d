#include "recording/coding/compression.h"

#include <gtest/gtest.h>

namespace ribbon::compression_test {

std::string compress_one(std::string_view content) {
  return Compressor().compress(content);
}

TEST(Compression, equal_input_gives_equal_bytes) {
  Compressor used;
  used.compress("something else before");
  EXPECT_EQ(used.compress("content content content"), compress_one("content content content"));
}

TEST(Compression, the_limit_is_kept) {
  const std::string bytes = compress_one(std::string(100'000, 'x'));
  EXPECT_LT(bytes.size(), 200U);
  EXPECT_TRUE(Decompressor().decompress(bytes, 100'000).has_value());
  EXPECT_FALSE(Decompressor().decompress(bytes, 99'999).has_value());
  EXPECT_FALSE(Decompressor().decompress(bytes, 0).has_value());
}

TEST(Compression, nothing_can_be_compressed) {
  EXPECT_EQ(Decompressor().decompress(compress_one(""), 0), "");
}

TEST(Compression, every_cut_and_every_appended_byte_is_noticed) {
  const std::string bytes = compress_one("some bytes, some more bytes");
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(Decompressor().decompress(bytes.substr(0, size), 1000).has_value()) << size;
  EXPECT_FALSE(Decompressor().decompress(bytes + "x", 1000).has_value());
}

TEST(Compression, a_decompressor_works_after_a_failure) {
  Decompressor decompressor;
  EXPECT_FALSE(decompressor.decompress("no zstd frame at all", 1000).has_value());
  EXPECT_EQ(decompressor.decompress(compress_one("fine"), 1000), "fine");
}

}  // namespace ribbon::compression_test
