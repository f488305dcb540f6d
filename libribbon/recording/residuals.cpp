#include "recording/residuals.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "recording/bit_string.h"
#include "recording/bytes.h"
#include "recording/symbol_form.h"
#include "recording/varint.h"

namespace ribbon {

namespace {

template <class Value>
using PerClass = std::array<Value, Activity::classes>;

using Counts = PerClass<std::uint64_t>;

// Visits all residuals in the order of the format, with their class.
template <class Visit>
void for_each_residual(const PaddedGrid& grid, const Activity& activity, Visit visit) {
  for (std::size_t component = 0; component < 3; ++component)
    for_each_particle(grid, [&](std::size_t at) {
      visit(component, at, activity.expected_class(component, at));
    });
}

Counts class_sizes(const PaddedGrid& grid, const Activity& activity) {
  Counts sizes{};
  for_each_residual(grid, activity, [&](std::size_t, std::size_t, std::size_t c) { ++sizes[c]; });
  return sizes;
}

PerClass<SymbolForm> best_forms(const PaddedGrid& grid, const Activity& activity,
                                const Residuals& residuals) {
  const Counts sizes = class_sizes(grid, activity);
  Counts sums{};
  for_each_residual(grid, activity, [&](std::size_t component, std::size_t at, std::size_t c) {
    sums[c] += zigzag(residuals[component][at]);
  });
  PerClass<SymbolForm> forms;
  for (std::size_t c = 0; c < forms.size(); ++c)
    forms[c] = form_for(static_cast<double>(sums[c]) /
                        static_cast<double>(std::max<std::uint64_t>(sizes[c], 1)));
  return forms;
}

// The sections of the content as they are taken apart, in the order of the format.
class Sections {
 public:
  Sections(const Counts& sizes, std::string_view bytes) : sizes_(sizes), rest_(bytes) {}

  // False where the bytes do not hold exactly these sections.
  bool take() { return take_forms() && take_symbols() && take_escapes() && take_low_bits(); }

  // The next number of class c.
  std::uint32_t next(std::size_t c) {
    const SymbolForm& form = forms_[c];
    std::uint32_t high = static_cast<std::uint8_t>(symbols_[c][used_[c]++]);
    if (high == form.escape()) high += escapes_[escapes_used_++];
    return (high << form.low_bits) | low_bits_.take_bits(form.low_bits);
  }

 private:
  bool take_forms() {
    for (SymbolForm& form : forms_) {
      ByteTaker taker(rest_);
      const auto known = form_of_code(taker.take<std::uint8_t>());
      if (!taker.complete() || !known) return false;
      form = *known;
      rest_ = taker.rest();
    }
    return true;
  }

  bool take_symbols() {
    for (std::size_t c = 0; c < forms_.size(); ++c) {
      ByteTaker taker(rest_);
      const std::string_view bytes = taker.take_bytes(forms_[c].bytes(sizes_[c]));
      if (!taker.complete()) return false;
      symbols_[c] = unpacked(bytes, forms_[c], sizes_[c]);
      rest_ = taker.rest();
    }
    return true;
  }

  bool take_escapes() {
    std::size_t count = 0;
    for (std::size_t c = 0; c < forms_.size(); ++c)
      count += static_cast<std::size_t>(std::count(symbols_[c].begin(), symbols_[c].end(),
                                                   static_cast<char>(forms_[c].escape())));
    escapes_.resize(count);
    for (std::uint32_t& escape : escapes_) {
      const auto taken = take_varint(rest_);
      if (!taken) return false;
      escape = *taken;
    }
    return true;
  }

  bool take_low_bits() {
    std::uint64_t bits = 0;
    for (std::size_t c = 0; c < forms_.size(); ++c)
      bits += sizes_[c] * static_cast<std::uint64_t>(forms_[c].low_bits);
    low_bits_ = BitTaker(rest_);
    return rest_.size() == (bits + 7) / 8;
  }

  Counts sizes_;
  std::string_view rest_;
  PerClass<SymbolForm> forms_;
  PerClass<std::string> symbols_;
  Counts used_{};
  std::vector<std::uint32_t> escapes_;
  std::size_t escapes_used_ = 0;
  BitTaker low_bits_{{}};
};

}  // namespace

std::vector<std::string> pack_residuals(const PaddedGrid& grid, const Activity& activity,
                                        const Residuals& residuals) {
  const PerClass<SymbolForm> forms = best_forms(grid, activity, residuals);
  PerClass<std::string> symbols;
  std::string escapes;
  BitPacker low_bits;
  for_each_residual(grid, activity, [&](std::size_t component, std::size_t at, std::size_t c) {
    const std::uint32_t number = zigzag(residuals[component][at]);
    const std::uint32_t high = number >> forms[c].low_bits;
    const std::uint32_t escape = forms[c].escape();
    symbols[c].push_back(static_cast<char>(std::min(high, escape)));
    if (high >= escape) put_varint(escapes, high - escape);
    low_bits.put_bits(number, forms[c].low_bits);
  });
  std::vector<std::string> parts(1);
  for (std::size_t c = 0; c < forms.size(); ++c) {
    put<std::uint8_t>(parts[0], form_code(forms[c]));
    parts.push_back(packed(symbols[c], forms[c]));
  }
  parts.push_back(std::move(escapes));
  parts.push_back(low_bits.finish());
  return parts;
}

bool unpack_residuals(const PaddedGrid& grid, const Activity& activity, std::string_view bytes,
                      Residuals& residuals) {
  Sections sections(class_sizes(grid, activity), bytes);
  if (!sections.take()) return false;
  for (Field& plane : residuals) plane.resize(grid.size());
  for_each_residual(grid, activity, [&](std::size_t component, std::size_t at, std::size_t c) {
    residuals[component][at] = unzigzag(sections.next(c));
  });
  return true;
}

std::size_t packed_residuals_limit(const PaddedGrid& grid) {
  // A symbol, a varint and four bytes of low bits per number.
  return Activity::classes + 3 * grid.size() * 10;
}

}  // namespace ribbon
