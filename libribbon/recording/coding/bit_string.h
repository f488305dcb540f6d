// Numbers of any few bits, one directly beside the other, from the lowest bit of each byte on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace ribbon {

class BitPacker {
 public:
  // The lowest `count` bits of `number`, at most 32.
  void put_bits(std::uint32_t number, int count) {
    pending_ |= (number & low_mask(count)) << filled_;
    for (filled_ += count; filled_ >= 8; filled_ -= 8, pending_ >>= 8)
      bytes_.push_back(static_cast<char>(static_cast<std::uint8_t>(pending_)));
  }

  // All of them, the last byte filled up with zeros.
  std::string finish() {
    if (filled_ > 0) put_bits(0, 8 - filled_);
    return std::move(bytes_);
  }

  static std::uint64_t low_mask(int count) { return (std::uint64_t{1} << count) - 1; }

 private:
  std::string bytes_;
  std::uint64_t pending_ = 0;
  int filled_ = 0;
};

class BitTaker {
 public:
  explicit BitTaker(std::string_view bytes) : bytes_(bytes) {}

  // At most 32 bits; zeros beyond the end.
  std::uint32_t take_bits(int count) {
    for (; filled_ < count; filled_ += 8) pending_ |= next_byte() << filled_;
    const auto number = static_cast<std::uint32_t>(pending_ & BitPacker::low_mask(count));
    pending_ >>= count;
    filled_ -= count;
    return number;
  }

 private:
  std::uint64_t next_byte() {
    return next_ < bytes_.size() ? static_cast<std::uint8_t>(bytes_[next_++]) : 0;
  }

  std::string_view bytes_;
  std::size_t next_ = 0;
  std::uint64_t pending_ = 0;
  int filled_ = 0;
};

}  // namespace ribbon
