#include "recording/coding/table.h"

namespace ribbon {

std::optional<std::string> take_columns(ByteTaker& taker, std::size_t rows, std::size_t row_bytes) {
  constexpr std::size_t largest_row_bytes = 1024;
  const auto compressed = taker.take_bytes(taker.take<std::uint32_t>());
  Decompressor decompressor;
  const auto content = decompressor.decompress(compressed, rows * largest_row_bytes);
  if (!taker.complete() || !content || content->size() < rows * row_bytes) return std::nullopt;
  if (rows == 0 ? !content->empty() : content->size() % rows != 0) return std::nullopt;
  return std::string(content->substr(0, rows * row_bytes));
}

}  // namespace ribbon
