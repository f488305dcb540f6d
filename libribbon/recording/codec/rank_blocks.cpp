#include "recording/codec/rank_blocks.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "recording/codec/frame_loops.h"
#include "recording/coding/bit_string.h"
#include "recording/coding/varint.h"

namespace ribbon {

namespace {

constexpr int block_columns = 4;
constexpr int block_particles = 64;

constexpr int largest_form = 31;

struct Form {
  int symbols_per_byte = 1;
  // The symbol that stands for itself and everything above. No larger than the ranks of such blocks
  // need: entropy tables have room for every symbol, and what has none is better for the others.
  std::uint32_t escape = 0;
  std::size_t kind = 0;
  int low_bits = 0;  // these are written elsewhere

  [[nodiscard]] int symbol_bits() const { return 8 / symbols_per_byte; }
  // Each column of a block begins a byte.
  [[nodiscard]] std::size_t bytes(const RankBlock& block) const {
    return block.columns * column_bytes(block.length);
  }
  [[nodiscard]] std::size_t column_bytes(std::size_t length) const {
    const auto per_byte = static_cast<std::size_t>(symbols_per_byte);
    return (length + per_byte - 1) / per_byte;
  }
};

// Of form 0 all ranks are 0; those from the last one here on differ in their low bits.
constexpr std::array<Form, symbol_kinds> first_forms = {
    {{1, 0, 0}, {4, 3, 1}, {2, 5, 2}, {2, 7, 3}, {2, 11, 4}, {1, 31, 5}, {1, 63, 6}, {1, 127, 7}}};

constexpr auto forms = [] {
  std::array<Form, largest_form + 1> all;
  for (std::size_t number = 0; number < all.size(); ++number) {
    all[number] = first_forms[std::min(number, first_forms.size() - 1)];
    all[number].low_bits = std::max(0, static_cast<int>(number - first_forms.size() + 1));
  }
  return all;
}();

const Form& form_of(int number) {
  return forms[static_cast<std::size_t>(number)];
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

void add_blocks(const ParityPlanes& planes, int plane, int first_column,
                std::vector<RankBlock>& blocks) {
  const int columns = std::min(block_columns, planes.columns(plane) - first_column);
  // Whole vectors of particles.
  const int length = columns > 2 ? block_particles / block_columns : block_particles / columns;
  for (int a = 0; a < planes.rows(plane); a += length)
    blocks.push_back({planes.cell(plane, a, first_column), static_cast<std::size_t>(columns),
                      static_cast<std::size_t>(std::min(length, planes.rows(plane) - a))});
}

// The ranks of a block of one component.
struct RankSummary {
  std::uint64_t sum = 0;
  std::uint32_t largest = 0;
};
RankSummary summary_of(const std::uint32_t* ranks, const RankBlock& block, std::size_t stride) {
  RankSummary summary;
  for (std::size_t b = 0; b < block.columns; ++b)
    for (std::size_t k = 0; k < block.length; ++k) {
      summary.sum += ranks[b * stride + k];
      summary.largest = std::max(summary.largest, ranks[b * stride + k]);
    }
  return summary;
}

template <int per_byte>
void put_symbols(const std::uint32_t* ranks, std::size_t length, const Form& form,
                 unsigned char* symbols) {
  for (std::size_t k = 0; k < length; k += per_byte) {
    std::uint32_t byte = 0;
    for (int part = 0; part < per_byte; ++part)
      if (const std::size_t at = k + static_cast<std::size_t>(part); at < length)
        byte |= std::min(ranks[at] >> form.low_bits, form.escape) << (8 / per_byte * part);
    *symbols++ = static_cast<unsigned char>(byte);
  }
}

// Packs the symbols of a column of a block.
void put_symbols(const std::uint32_t* ranks, std::size_t length, const Form& form,
                 std::string& symbols) {
  const std::size_t begin = symbols.size();
  symbols.resize(begin + form.column_bytes(length));
  auto* out = reinterpret_cast<unsigned char*>(symbols.data() + begin);
  if (form.symbols_per_byte == 4) return put_symbols<4>(ranks, length, form, out);
  if (form.symbols_per_byte == 2) return put_symbols<2>(ranks, length, form, out);
  put_symbols<1>(ranks, length, form, out);
}

// What symbols cannot hold.
void put_rest(const std::uint32_t* ranks, std::size_t length, const Form& form,
              std::string& escapes, BitPacker& low_bits) {
  for (std::size_t k = 0; k < length; ++k) {
    const std::uint32_t high = ranks[k] >> form.low_bits;
    if (high >= form.escape) put_varint(escapes, high - form.escape);
    if (form.low_bits > 0) low_bits.put_bits(ranks[k], form.low_bits);
  }
}

// From the form of the block before: nearly always a small step.
unsigned char form_step(int form, int before) {
  return static_cast<unsigned char>(zigzag(form - before));
}

}  // namespace

std::vector<RankBlock> rank_blocks(const ParityPlanes& planes) {
  std::vector<RankBlock> blocks;
  for (const int plane : ParityPlanes::order)
    for (int b = 0; b < planes.columns(plane); b += block_columns)
      add_blocks(planes, plane, b, blocks);
  return blocks;
}

std::vector<unsigned char> symbols_of(std::size_t kind) {
  if (kind == form_kind) {
    std::vector<unsigned char> steps;
    for (int step = -largest_form; step <= largest_form; ++step)
      steps.push_back(form_step(step, 0));
    return steps;
  }
  const Form& form = first_forms[kind];
  std::vector<unsigned char> symbols = {0};
  for (int part = 0; part < form.symbols_per_byte; ++part) {
    const std::vector<unsigned char> before = symbols;
    for (std::uint32_t symbol = 1; symbol <= form.escape; ++symbol)
      for (const unsigned char rest : before)
        symbols.push_back(static_cast<unsigned char>(rest | symbol << (form.symbol_bits() * part)));
  }
  return symbols;
}

void RankPacker::append(const Ranks& ranks, std::string& bytes) {
  for (std::string& run : runs_) run.clear();
  std::string escapes;
  BitPacker low_bits;
  for (const auto& component : ranks) {
    int before = 0;
    for (const RankBlock& block : blocks_) {
      const std::uint32_t* first = component.data() + block.cell;
      const RankSummary summary = summary_of(first, block, stride_);
      const int number = form_for(summary.sum, block.particles());
      runs_[form_kind].push_back(static_cast<char>(form_step(number, before)));
      before = number;
      if (number == 0) continue;
      const Form& form = form_of(number);
      for (std::size_t b = 0; b < block.columns; ++b)
        put_symbols(first + b * stride_, block.length, form, runs_[form.kind]);
      if (form.low_bits == 0 && summary.largest < form.escape) continue;
      for (std::size_t b = 0; b < block.columns; ++b)
        put_rest(first + b * stride_, block.length, form, escapes, low_bits);
    }
  }
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind)
    compressor_.append(kind, runs_[kind], bytes);
  bytes += escapes;
  bytes += low_bits.finish();
}

RankUnpacker::RankUnpacker(const ParityPlanes& planes, std::span<const std::string> entropy_tables)
    : cells_(planes.cells()),
      stride_(static_cast<std::size_t>(planes.stride())),
      decompressor_(entropy_tables),
      blocks_(rank_blocks(planes)) {}

bool RankUnpacker::take_forms(std::string_view& bytes) {
  forms_.resize(3 * blocks_.size());
  if (!decompressor_.take(form_kind, bytes, forms_.size(), forms_.data())) return false;
  for (std::size_t component = 0; component < 3; ++component) {
    int before = 0;
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
      unsigned char& form = forms_[component * blocks_.size() + block];
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
      const Form& form = form_of(forms_[block]);
      sizes[form.kind] += form.bytes(blocks_[block % blocks_.size()]);
    }
  for (std::size_t kind = 1; kind < symbol_kinds; ++kind) {
    symbols_[kind].resize(sizes[kind] + ParityPlanes::lane_quantum);  // whole vectors are read
    if (!decompressor_.take(kind, bytes, sizes[kind], symbols_[kind].data())) return false;
  }
  return true;
}

namespace {

bool take_escapes(std::string_view& bytes, std::uint32_t escape, std::size_t count,
                  std::uint32_t* ranks) {
  for (std::size_t k = 0; k < count; ++k) {
    if (ranks[k] < escape) continue;
    const auto more = take_varint(bytes);
    if (!more || *more > std::numeric_limits<std::uint32_t>::max() - ranks[k]) return false;
    ranks[k] += *more;
  }
  return true;
}

}  // namespace

bool RankUnpacker::spread_symbols(std::string_view& bytes, Ranks& ranks) const {
  std::array<const unsigned char*, symbol_kinds> next{};
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind) next[kind] = symbols_[kind].data();
  const unsigned char* number = forms_.data();
  const auto spread = loops().spread;
  for (auto& component : ranks) {
    component.resize(cells_);
    for (const RankBlock& block : blocks_) {
      const Form& form = form_of(*number++);
      std::uint32_t* first = component.data() + block.cell;
      if (form.kind == 0) {
        for (std::size_t b = 0; b < block.columns; ++b)
          std::fill_n(first + b * stride_, block.length, 0U);
        continue;
      }
      const bool escapes = spread(form.symbol_bits(), form.escape, next[form.kind], block.columns,
                                  block.length, stride_, first);
      next[form.kind] += form.bytes(block);
      for (std::size_t b = 0; escapes && b < block.columns; ++b)
        if (!take_escapes(bytes, form.escape, block.length, first + b * stride_)) return false;
    }
  }
  return true;
}

bool RankUnpacker::add_low_bits(std::string_view bytes, Ranks& ranks) const {
  std::uint64_t count = 0;
  for (std::size_t block = 0; block < forms_.size(); ++block)
    count += static_cast<std::uint64_t>(form_of(forms_[block]).low_bits) *
             blocks_[block % blocks_.size()].particles();
  if (bytes.size() != (count + 7) / 8) return false;
  if (count == 0) return true;
  BitTaker low_bits(bytes);
  const unsigned char* number = forms_.data();
  for (auto& component : ranks)
    for (const RankBlock& block : blocks_) {
      const int bits = form_of(*number++).low_bits;
      if (bits == 0) continue;
      for (std::size_t b = 0; b < block.columns; ++b)
        for (std::size_t k = 0; k < block.length; ++k) {
          std::uint32_t& rank = component[block.cell + b * stride_ + k];
          if (std::uint64_t{rank} >> (32 - bits) != 0) return false;
          rank = (rank << bits) | low_bits.take_bits(bits);
        }
    }
  return true;
}

bool RankUnpacker::unpack(std::string_view bytes, Ranks& ranks) {
  return take_forms(bytes) && take_symbols(bytes) && spread_symbols(bytes, ranks) &&
         add_low_bits(bytes, ranks);
}

}  // namespace ribbon
