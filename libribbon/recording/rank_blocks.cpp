#include "recording/rank_blocks.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "recording/bit_string.h"
#include "recording/varint.h"

namespace ribbon {

namespace {

constexpr std::size_t block_particles = 64;

// Form 0: all ranks are 0. Forms 1 and 2: four symbols in a byte; 3 and 4: two; 5 to 7: one. Form
// 7 + n: likewise, after the n lowest bits, which are written elsewhere.
constexpr int largest_form = 31;

struct Form {
  int low_bits = 0;
  int symbols_per_byte = 1;
  std::size_t kind = 0;

  [[nodiscard]] int symbol_bits() const { return 8 / symbols_per_byte; }
  // The symbol that stands for itself and everything above.
  [[nodiscard]] std::uint32_t escape() const { return (std::uint32_t{1} << symbol_bits()) - 1; }
  [[nodiscard]] std::size_t bytes(std::size_t count) const {
    const auto per_byte = static_cast<std::size_t>(symbols_per_byte);
    return (count + per_byte - 1) / per_byte;
  }
};

Form form_of(int number) {
  if (number <= 2) return {0, 4, static_cast<std::size_t>(number)};
  if (number <= 4) return {0, 2, static_cast<std::size_t>(number)};
  return {std::max(0, number - 7), 1, static_cast<std::size_t>(std::min(number, 7))};
}

// For ranks of this sum and count.
int form_for(std::uint64_t sum, std::size_t count) {
  if (sum == 0) return 0;
  // Means, in sixteenths, from which on the next form is smaller.
  constexpr std::array<std::uint64_t, 6> limits = {3, 8, 17, 34, 66, 130};
  const std::uint64_t mean = 16 * sum / count;
  for (std::size_t form = 0; form < limits.size(); ++form)
    if (mean < limits[form]) return static_cast<int>(form) + 1;
  return std::min(largest_form, 7 + std::max(0, static_cast<int>(std::bit_width(mean)) - 9));
}

std::vector<std::size_t> block_sizes(const ParityPlanes& planes) {
  std::vector<std::size_t> sizes;
  for (const int plane : {0, 3, 1, 2})
    for (std::size_t left = planes.particles(plane); left > 0; left -= sizes.back())
      sizes.push_back(std::min(left, block_particles));
  return sizes;
}

// Packs symbols of one block; escapes and low bits go elsewhere.
void put_block(const std::uint32_t* ranks, std::size_t count, const Form& form,
               std::string& symbols, std::string& escapes, BitPacker& low_bits) {
  const std::size_t begin = symbols.size();
  symbols.resize(begin + form.bytes(count));
  const auto per_byte = static_cast<std::size_t>(form.symbols_per_byte);
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t high = ranks[k] >> form.low_bits;
    const std::uint32_t symbol = std::min(high, form.escape());
    if (symbol == form.escape()) put_varint(escapes, high - symbol);
    if (form.low_bits > 0) low_bits.put_bits(ranks[k], form.low_bits);
    char& byte = symbols[begin + k / per_byte];
    byte = static_cast<char>(static_cast<unsigned char>(byte) |
                             (symbol << (static_cast<int>(k % per_byte) * form.symbol_bits())));
  }
}

// From the form of the block before: nearly always a small step.
unsigned char form_step(int form, int before) {
  return static_cast<unsigned char>(zigzag(form - before));
}

}  // namespace

void RankPacker::append(const Ranks& ranks, std::string& bytes) {
  for (std::string& run : runs_) run.clear();
  std::string escapes;
  BitPacker low_bits;
  for (const auto& component : ranks) {
    const std::uint32_t* block = component.data();
    int before = 0;
    for (const std::size_t count : block_sizes(planes_)) {
      std::uint64_t sum = 0;
      for (std::size_t k = 0; k < count; ++k) sum += block[k];
      const int number = form_for(sum, count);
      runs_[form_kind].push_back(static_cast<char>(form_step(number, before)));
      const Form form = form_of(number);
      if (number > 0) put_block(block, count, form, runs_[form.kind], escapes, low_bits);
      before = number;
      block += count;
    }
  }
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind)
    compressor_.append(kind, runs_[kind], bytes);
  bytes += escapes;
  bytes += low_bits.finish();
}

RankUnpacker::RankUnpacker(const ParityPlanes& planes, std::span<const std::string> entropy_tables)
    : planes_(planes), decompressor_(entropy_tables), block_sizes_(block_sizes(planes)) {}

bool RankUnpacker::take_forms(std::string_view& bytes) {
  forms_.resize(3 * block_sizes_.size());
  if (!decompressor_.take(form_kind, bytes, forms_.size(), forms_.data())) return false;
  for (std::size_t component = 0; component < 3; ++component) {
    int before = 0;
    for (std::size_t block = 0; block < block_sizes_.size(); ++block) {
      unsigned char& form = forms_[component * block_sizes_.size() + block];
      before += unzigzag(form);
      if (before < 0 || before > largest_form) return false;
      form = static_cast<unsigned char>(before);
    }
  }
  return true;
}

bool RankUnpacker::take_symbols(std::string_view& bytes) {
  std::array<std::size_t, symbol_kinds> sizes{};
  for (std::size_t block = 0; block < forms_.size(); ++block)
    if (forms_[block] > 0) {
      const Form form = form_of(forms_[block]);
      sizes[form.kind] += form.bytes(block_sizes_[block % block_sizes_.size()]);
    }
  for (std::size_t kind = 1; kind < symbol_kinds; ++kind) {
    symbols_[kind].resize(sizes[kind]);
    if (!decompressor_.take(kind, bytes, sizes[kind], symbols_[kind].data())) return false;
  }
  return true;
}

namespace {

// Spreads the symbols of a block over its ranks; true where an escape is among them.
template <int per_byte>
bool spread(const unsigned char* __restrict symbols, std::size_t count,
            std::uint32_t* __restrict ranks) {
  constexpr int bits = 8 / per_byte;
  constexpr std::uint32_t escape = (1U << bits) - 1;
  std::uint32_t escapes = 0;
  const std::size_t whole = count / per_byte;
  for (std::size_t k = 0; k < whole; ++k)
    for (int part = 0; part < per_byte; ++part) {
      const std::uint32_t rank = (std::uint32_t{symbols[k]} >> (bits * part)) & escape;
      ranks[k * per_byte + static_cast<std::size_t>(part)] = rank;
      escapes |= rank == escape ? 1U : 0U;
    }
  for (std::size_t k = whole * per_byte; k < count; ++k) {
    ranks[k] = (std::uint32_t{symbols[whole]} >> (bits * static_cast<int>(k % per_byte))) & escape;
    escapes |= ranks[k] == escape ? 1U : 0U;
  }
  return escapes != 0;
}

bool spread_block(const Form& form, const unsigned char* symbols, std::size_t count,
                  std::uint32_t* ranks) {
  if (form.symbols_per_byte == 4) return spread<4>(symbols, count, ranks);
  if (form.symbols_per_byte == 2) return spread<2>(symbols, count, ranks);
  return spread<1>(symbols, count, ranks);
}

bool take_escapes(std::string_view& bytes, std::uint32_t escape, std::size_t count,
                  std::uint32_t* ranks) {
  for (std::size_t k = 0; k < count; ++k) {
    if (ranks[k] != escape) continue;
    const auto more = take_varint(bytes);
    if (!more) return false;
    ranks[k] += *more;
  }
  return true;
}

}  // namespace

bool RankUnpacker::unpack(std::string_view bytes, Ranks& ranks) {
  if (!take_forms(bytes) || !take_symbols(bytes)) return false;
  std::array<const unsigned char*, symbol_kinds> next{};
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind) next[kind] = symbols_[kind].data();
  std::size_t block = 0;
  std::uint64_t low_bit_count = 0;
  for (auto& component : ranks) {
    component.resize(room_for_ranks(planes_.grid()));
    std::uint32_t* out = component.data();
    for (const std::size_t count : block_sizes_) {
      const int number = forms_[block++];
      if (number == 0) {
        std::fill_n(out, count, 0U);
      } else {
        const Form form = form_of(number);
        const bool escapes = spread_block(form, next[form.kind], count, out);
        next[form.kind] += form.bytes(count);
        if (escapes && !take_escapes(bytes, form.escape(), count, out)) return false;
        low_bit_count += static_cast<std::uint64_t>(form.low_bits) * count;
      }
      out += count;
    }
  }
  if (bytes.size() != (low_bit_count + 7) / 8) return false;
  if (low_bit_count == 0) return true;
  BitTaker low_bits(bytes);
  block = 0;
  for (auto& component : ranks) {
    std::uint32_t* out = component.data();
    for (const std::size_t count : block_sizes_) {
      const int bits = form_of(forms_[block++]).low_bits;
      if (bits > 0)
        for (std::size_t k = 0; k < count; ++k)
          out[k] = (out[k] << bits) | low_bits.take_bits(bits);
      out += count;
    }
  }
  return true;
}

}  // namespace ribbon
