// Gives the records of a recording right checksums again, so that a fuzzer gets past them.
#pragma once

#include <cstdint>
#include <span>

namespace ribbon {

// Every record that is found gets the checksum of its head, and where it is whole that of its
// payload; records that named the recording by the checksum of its header name it by the new one.
void repair_checksums(std::span<std::uint8_t> file);

}  // namespace ribbon
