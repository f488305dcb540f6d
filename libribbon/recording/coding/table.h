// Tables inside payloads: rows of numbers, compressed column by column (FORMAT.md, section 6).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "recording/coding/bytes.h"
#include "recording/coding/compression.h"

namespace ribbon {

// Columns are pointers to the numbers of a row, in their order.
template <class Row, class... Numbers>
void put_table(std::string& bytes, const std::vector<Row>& rows,
               const std::tuple<Numbers...>& columns) {
  std::string content;
  const auto put_column = [&](auto column) {
    using Number = std::remove_cvref_t<decltype(std::declval<Row>().*column)>;
    for (const Row& row : rows) put<Number>(content, row.*column);
  };
  std::apply([&](auto... column) { (put_column(column), ...); }, columns);
  put_string(bytes, Compressor().compress(content));
}

// The content of the next block of `rows` rows, as far as columns that take row_bytes in all; those
// that a later version has put behind them are left out. Nothing where there is less, or part of a
// column.
std::optional<std::string> take_columns(ByteTaker& taker, std::size_t rows, std::size_t row_bytes);

// The inverse of put_table(), of so many rows; false where they are not there.
template <class Row, class... Numbers>
bool take_table(ByteTaker& taker, std::size_t count, std::vector<Row>& rows,
                const std::tuple<Numbers...>& columns) {
  const auto content =
      take_columns(taker, count, (sizeof(std::declval<Row>().*std::declval<Numbers>()) + ...));
  if (!content) return false;
  rows.resize(count);
  ByteTaker numbers(*content);
  const auto take_column = [&](auto column) {
    using Number = std::remove_cvref_t<decltype(std::declval<Row>().*column)>;
    for (Row& row : rows) row.*column = numbers.take<Number>();
  };
  std::apply([&](auto... column) { (take_column(column), ...); }, columns);
  return true;
}

}  // namespace ribbon
