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

// The content of the next block; nothing where it does not hold exactly `size` bytes.
std::optional<std::string> take_block(ByteTaker& taker, std::size_t size);

}  // namespace ribbon
