// What was packed into a page, read by the words of its declaration.
#pragma once

#include <libdeflate.h>

#include <memory>
#include <string>
#include <string_view>

namespace ribbon {

// The reverse of seven_bits().
inline std::string bytes_of_seven_bits(std::string_view text) {
  std::string bits;
  for (std::size_t i = 0; i < text.size(); ++i) {
    auto letter = static_cast<unsigned char>(text[i]);
    if (letter >= 0x80)
      letter = static_cast<unsigned char>((letter & 0x03U) << 6U | (text[++i] & 0x3FU));
    for (int bit = 6; bit >= 0; --bit) bits += (letter >> bit & 1U) != 0 ? '1' : '0';
  }
  std::string bytes;
  for (std::size_t i = 0; i + 8 <= bits.size(); i += 8)
    bytes += static_cast<char>(std::stoi(bits.substr(i, 8), nullptr, 2));
  return bytes;
}

// The reverse of packed(), of at most so many bytes; empty where it is none of these.
inline std::string unpacked(std::string_view text, std::size_t most) {
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> one(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  const std::string gzip = bytes_of_seven_bits(text);
  std::string bytes(most, '\0');
  std::size_t size = 0;
  if (libdeflate_gzip_decompress(one.get(), gzip.data(), gzip.size(), bytes.data(), bytes.size(),
                                 &size) != LIBDEFLATE_SUCCESS)
    return "";
  bytes.resize(size);
  return bytes;
}

}  // namespace ribbon
