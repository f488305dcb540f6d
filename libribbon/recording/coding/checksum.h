// The checksum of records.
#pragma once

#include <cstdint>
#include <string_view>

namespace ribbon {

// CRC-32 as in zlib, PNG and gzip.
std::uint32_t checksum(std::string_view bytes);

}  // namespace ribbon
