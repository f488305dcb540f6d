#include "converter/export/content_key.h"

#include <bit>
#include <cstring>

namespace ribbon {

namespace {

constexpr std::size_t block_bytes = 16;
constexpr std::uint64_t c1 = 0x87c37b91114253d5;
constexpr std::uint64_t c2 = 0x4cf5ad432745937f;

// Two numbers from at most one block, filled up with zeros.
ContentKey words_of(std::string_view block) {
  ContentKey words{};
  std::memcpy(words.data(), block.data(), block.size());
  return words;
}

std::uint64_t mixed_first(std::uint64_t word) {
  return std::rotl(word * c1, 31) * c2;
}

std::uint64_t mixed_second(std::uint64_t word) {
  return std::rotl(word * c2, 33) * c1;
}

std::uint64_t avalanched(std::uint64_t hash) {
  hash = (hash ^ (hash >> 33U)) * 0xff51afd7ed558ccd;
  hash = (hash ^ (hash >> 33U)) * 0xc4ceb9fe1a85ec53;
  return hash ^ (hash >> 33U);
}

}  // namespace

ContentKey content_key(std::string_view bytes) {
  auto [h1, h2] = ContentKey{};
  std::string_view rest = bytes;
  for (; rest.size() >= block_bytes; rest.remove_prefix(block_bytes)) {
    const auto [k1, k2] = words_of(rest.substr(0, block_bytes));
    h1 = (std::rotl(h1 ^ mixed_first(k1), 27) + h2) * 5 + 0x52dce729;
    h2 = (std::rotl(h2 ^ mixed_second(k2), 31) + h1) * 5 + 0x38495ab5;
  }
  const auto [k1, k2] = words_of(rest);
  h1 ^= mixed_first(k1) ^ bytes.size();
  h2 ^= mixed_second(k2) ^ bytes.size();
  h1 += h2;
  h2 += h1;
  h1 = avalanched(h1);
  h2 = avalanched(h2);
  h1 += h2;
  return {h1, h2 + h1};
}

}  // namespace ribbon
