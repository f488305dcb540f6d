// Little-endian numbers in byte strings, whatever the machine's own order.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace ribbon {

template <class Number>
using BitsOf = std::conditional_t<
    sizeof(Number) == 8, std::uint64_t,
    std::conditional_t<sizeof(Number) == 4, std::uint32_t,
                       std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint8_t>>>;

// Appends a number of fixed size: put<std::uint32_t>(bytes, 7).
template <class Number>
void put(std::string& bytes, std::type_identity_t<Number> number) {
  const auto bits = Eigen::numext::bit_cast<BitsOf<Number>>(number);
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    bytes.push_back(static_cast<char>(static_cast<std::uint8_t>(bits >> (8 * i))));
}

// Takes numbers off the front of some bytes. After a take beyond the end everything taken is zero
// and complete() is false: check once, after the last take and before using any of it.
class ByteTaker {
 public:
  explicit ByteTaker(std::string_view bytes) : rest_(bytes) {}

  template <class Number>
  Number take() {
    BitsOf<Number> bits = 0;
    const std::string_view bytes = take_bytes(sizeof(Number));
    for (std::size_t i = 0; i < bytes.size(); ++i)
      bits = static_cast<BitsOf<Number>>(
          bits | (static_cast<BitsOf<Number>>(static_cast<std::uint8_t>(bytes[i])) << (8 * i)));
    return Eigen::numext::bit_cast<Number>(bits);
  }

  // `count` bytes; none of them where fewer are left.
  std::string_view take_bytes(std::size_t count) {
    if (count > rest_.size()) complete_ = false;
    if (!complete_) return {};
    const std::string_view bytes = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return bytes;
  }

  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  std::string_view rest_;
  bool complete_ = true;
};

// A byte count of four bytes and that many bytes.
inline void put_string(std::string& bytes, std::string_view text) {
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}

inline std::string take_string(ByteTaker& taker) {
  return std::string(taker.take_bytes(taker.take<std::uint32_t>()));
}

}  // namespace ribbon
