// How the residuals of one class lie in bytes (FORMAT.md, section 8.4).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ribbon {

struct SymbolForm {
  int low_bits = 0;          // of each number; these go elsewhere
  int symbols_per_byte = 1;  // of the rest: 1, 2 or 4

  [[nodiscard]] int symbol_bits() const { return 8 / symbols_per_byte; }
  // The symbol that stands for itself and everything above.
  [[nodiscard]] std::uint32_t escape() const { return (std::uint32_t{1} << symbol_bits()) - 1; }
  [[nodiscard]] std::uint64_t bytes(std::uint64_t symbols) const;
};

// The form for numbers of this mean. Entropy coding spends at least one bit on a byte, so numbers
// that are nearly always zero share one; of large numbers it gets only the part that is not noise.
SymbolForm form_for(double mean);

// As recorded, and the inverse: nothing for a code that does not exist.
std::uint8_t form_code(const SymbolForm& form);
std::optional<SymbolForm> form_of_code(std::uint8_t code);

// From symbols that lie one to a byte, and back; bytes: form.bytes(count) of them.
std::string packed(std::string_view symbols, const SymbolForm& form);
std::string unpacked(std::string_view bytes, const SymbolForm& form, std::uint64_t count);

}  // namespace ribbon
