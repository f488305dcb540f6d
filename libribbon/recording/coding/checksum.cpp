#include "recording/coding/checksum.h"

#include <libdeflate.h>

namespace ribbon {

std::uint32_t checksum(std::string_view bytes) {
  return libdeflate_crc32(0, bytes.data(), bytes.size());
}

}  // namespace ribbon
