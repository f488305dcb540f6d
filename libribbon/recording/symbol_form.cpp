#include "recording/symbol_form.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace ribbon {

std::uint64_t SymbolForm::bytes(std::uint64_t symbols) const {
  const auto per_byte = static_cast<std::uint64_t>(symbols_per_byte);
  return (symbols + per_byte - 1) / per_byte;
}

SymbolForm form_for(double mean) {
  if (mean < 0.5) return {0, 4};
  if (mean < 2) return {0, 2};
  const int bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(mean)));
  return {std::max(0, bits - 5), 1};
}

std::uint8_t form_code(const SymbolForm& form) {
  if (form.symbols_per_byte == 1) return static_cast<std::uint8_t>(form.low_bits);
  return form.symbols_per_byte == 2 ? 32 : 33;
}

std::optional<SymbolForm> form_of_code(std::uint8_t code) {
  if (code < 32) return SymbolForm{code, 1};
  if (code == 32) return SymbolForm{0, 2};
  if (code == 33) return SymbolForm{0, 4};
  return std::nullopt;
}

std::string packed(std::string_view symbols, const SymbolForm& form) {
  std::string bytes(form.bytes(symbols.size()), '\0');
  const auto per_byte = static_cast<std::size_t>(form.symbols_per_byte);
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const int shift = static_cast<int>(i % per_byte) * form.symbol_bits();
    char& byte = bytes[i / per_byte];
    byte = static_cast<char>(static_cast<std::uint8_t>(byte) |
                             (static_cast<std::uint8_t>(symbols[i]) << shift));
  }
  return bytes;
}

std::string unpacked(std::string_view bytes, const SymbolForm& form, std::uint64_t count) {
  std::string symbols(count, '\0');
  const auto per_byte = static_cast<std::size_t>(form.symbols_per_byte);
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const int shift = static_cast<int>(i % per_byte) * form.symbol_bits();
    symbols[i] = static_cast<char>((static_cast<std::uint8_t>(bytes[i / per_byte]) >> shift) &
                                   form.escape());
  }
  return symbols;
}

}  // namespace ribbon
