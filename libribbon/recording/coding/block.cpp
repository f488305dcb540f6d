#include "recording/coding/block.h"

#include "recording/coding/compression.h"

namespace ribbon {

void put_block(std::string& bytes, std::string_view content) {
  put_string(bytes, Compressor().compress(content));
}

std::optional<std::string> take_block(ByteTaker& taker, std::size_t size) {
  const auto compressed = taker.take_bytes(taker.take<std::uint32_t>());
  Decompressor decompressor;
  const auto content = decompressor.decompress(compressed, size);
  if (!taker.complete() || !content || content->size() != size) return std::nullopt;
  return std::string(*content);
}

}  // namespace ribbon
