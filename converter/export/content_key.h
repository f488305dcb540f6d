// A key that two pieces of data share only if they are the same.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace ribbon {

using ContentKey = std::array<std::uint64_t, 2>;

// Austin Appleby's MurmurHash3 (x64, 128 bits, seed 0), which Alembic's readers know samples by.
ContentKey content_key(std::string_view bytes);

}  // namespace ribbon
