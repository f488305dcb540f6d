#include "recording/coding/compression.h"

#include <gtest/gtest.h>

#include <cstdint>
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
  SymbolCompressor().append(2, symbols, bytes);
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
    ByteTaker left(bytes);
    std::vector<unsigned char> taken(symbols.size());
    ASSERT_TRUE(SymbolDecompressor().take(2, left, taken));
    EXPECT_EQ(taken, symbols) << kinds;
    EXPECT_EQ(left.rest(), "rest");
  }
}

// Two hundred kinds leave a twentieth to be gained, a hundred and sixty a twelfth.
TEST(SymbolCoding, what_saves_less_than_a_sixteenth_is_left_as_it_is) {
  EXPECT_EQ(coded(even_symbols(200)).size(), 20'004U);
  EXPECT_EQ(coded(even_symbols(200)).substr(0, 4), std::string(4, '\0'));
  EXPECT_LT(coded(even_symbols(160)).size(), 20'000U * 15 / 16);
}

// Of all kinds of runs, and of those too short to be worth a table of their own.
TEST(SymbolCoding, a_run_is_taken_as_the_kind_that_it_is) {
  std::vector<unsigned char> symbols(300);
  for (std::size_t k = 0; k < symbols.size(); ++k) symbols[k] = k % 5 == 0 ? 0x11 : 0;
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind) {
    std::string bytes;
    SymbolCompressor().append(kind, symbols, bytes);
    EXPECT_LT(bytes.size(), 160U) << kind;
    ByteTaker left(bytes);
    std::vector<unsigned char> taken(symbols.size());
    ASSERT_TRUE(SymbolDecompressor().take(kind, left, taken));
    EXPECT_EQ(taken, symbols) << kind;
  }
}

// In blocks of mode 1 all kinds of bytes occur; a table of its own would be a third of the run.
TEST(SymbolCoding, tables_that_are_known_save_those_of_short_runs) {
  std::mt19937 random(7);
  std::vector<unsigned char> symbols(400);
  for (unsigned char& symbol : symbols)
    for (unsigned k = 0; k < 4; ++k) {
      const std::uint32_t dice = random() % 16;
      symbol |= static_cast<unsigned char>((dice < 10   ? 0
                                            : dice < 13 ? 3
                                            : dice < 15 ? 1
                                                        : 2)
                                           << 2 * k);
    }
  std::string known;
  SymbolCompressor().append(1, symbols, known);
  EXPECT_LT(known.size(), 380U);
  std::string unknown;
  SymbolCompressor().append(2, symbols, unknown);
  EXPECT_GT(unknown.size(), known.size() + 15);
}

}  // namespace ribbon::compression_test
