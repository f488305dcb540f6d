// Compressed blocks inside payloads (FORMAT.md, conventions).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "recording/coding/bytes.h"

namespace ribbon {

// Appends `content`, compressed.
void put_block(std::string& bytes, std::string_view content);

// The next block, a table column by column: of so many rows those columns that take row_bytes.
// Columns that a later version has put behind them are left out. Nothing where there is less, or
// part of a column.
std::optional<std::string> take_table(ByteTaker& taker, std::size_t rows, std::size_t row_bytes);

}  // namespace ribbon
