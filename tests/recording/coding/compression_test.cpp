#include "recording/coding/compression.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

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

std::string coded(const std::vector<unsigned char>& symbols) {
  std::string bytes;
  SymbolCompressor().append(symbols, bytes);
  return bytes;
}

// Numbers below `kinds`, each as often as any other.
std::vector<unsigned char> even_symbols(unsigned kinds) {
  std::mt19937 random(7);
  std::vector<unsigned char> symbols(20'000);
  for (unsigned char& symbol : symbols) symbol = static_cast<unsigned char>(random() % kinds);
  return symbols;
}

TEST(SymbolCoding, symbols_come_back) {
  for (const unsigned kinds : {1U, 2U, 20U, 200U, 256U}) {
    const auto symbols = even_symbols(kinds);
    const std::string bytes = coded(symbols) + "rest";
    std::string_view left = bytes;
    std::vector<unsigned char> taken(symbols.size());
    ASSERT_TRUE(SymbolDecompressor().take(left, taken));
    EXPECT_EQ(taken, symbols) << kinds;
    EXPECT_EQ(left, "rest");
  }
}

// Two hundred kinds leave a twentieth to be gained, a hundred and sixty a twelfth.
TEST(SymbolCoding, what_saves_less_than_a_sixteenth_is_left_as_it_is) {
  EXPECT_EQ(coded(even_symbols(200)).size(), 20'001U);
  EXPECT_EQ(coded(even_symbols(200)).front(), '\0');
  EXPECT_LT(coded(even_symbols(160)).size(), 20'000U * 15 / 16);
}

}  // namespace ribbon::compression_test
