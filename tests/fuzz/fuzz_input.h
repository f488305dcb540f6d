// Bytes that a fuzzer made, taken from the front as numbers; 0 once they are used up.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace ribbon {

class FuzzInput {
 public:
  FuzzInput(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  // Any number of `Number`'s kind, whatever its bits: infinities and NaN as well.
  template <class Number>
  Number take() {
    Number number{};
    const std::size_t bytes = std::min(sizeof(Number), size_);
    if (bytes > 0) std::memcpy(&number, data_, bytes);
    drop(bytes);
    return number;
  }

  // From smallest to largest, at most 255 apart.
  int between(int smallest, int largest) {
    return smallest + take<std::uint8_t>() % (largest - smallest + 1);
  }

  [[nodiscard]] std::string_view rest() const {
    return {reinterpret_cast<const char*>(data_), size_};
  }

 private:
  void drop(std::size_t bytes) {
    data_ += bytes;
    size_ -= bytes;
  }

  const std::uint8_t* data_;
  std::size_t size_;
};

// A copy that ends where its block of memory does, so that the sanitizer sees every byte read past
// it.
class ExactCopy {
 public:
  explicit ExactCopy(std::string_view bytes) : bytes_(bytes.begin(), bytes.end()) {}
  [[nodiscard]] std::string_view view() const { return {bytes_.data(), bytes_.size()}; }

 private:
  std::vector<char> bytes_;
};

}  // namespace ribbon
