#include "recording/codec/residual_blocks.h"

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

constexpr int largest_mode = 31;

struct CodingMode {
  int symbols_per_byte = 1;
  // The symbol that stands for itself and everything above. No larger than the residuals of such
  // blocks need: entropy tables have room for every symbol, and what has none is better for the
  // others.
  std::uint32_t escape = 0;
  std::size_t kind = 0;
  int low_bits = 0;  // these are written elsewhere

  [[nodiscard]] int symbol_bits() const { return 8 / symbols_per_byte; }
  // Each column of a block begins a byte.
  [[nodiscard]] std::size_t bytes(const ResidualBlock& block) const {
    return block.columns * column_bytes(block.length);
  }
  [[nodiscard]] std::size_t column_bytes(std::size_t length) const {
    return (length + symbols_per_byte - 1) / symbols_per_byte;
  }
};

// Of mode 0 all residuals are 0; those from the last one here on differ in their low bits.
constexpr std::array<CodingMode, symbol_kinds> first_modes = {
    {{1, 0, 0}, {4, 3, 1}, {2, 5, 2}, {2, 7, 3}, {2, 11, 4}, {1, 31, 5}, {1, 63, 6}, {1, 127, 7}}};

constexpr auto modes = [] {
  std::array<CodingMode, largest_mode + 1> all;
  for (std::size_t number = 0; number < all.size(); ++number) {
    all[number] = first_modes[std::min(number, first_modes.size() - 1)];
    all[number].low_bits = std::max(0, static_cast<int>(number - first_modes.size() + 1));
  }
  return all;
}();

const CodingMode& mode_of(int number) {
  return modes[number];
}

// For residuals of this sum and count.
int mode_for(std::uint64_t sum, std::size_t count) {
  if (sum == 0) return 0;
  // Means, in sixteenths, from which on the next mode is smaller.
  constexpr std::array<std::uint64_t, 6> limits = {3, 8, 17, 34, 66, 130};
  const std::uint64_t mean = 16 * sum / count;
  for (std::size_t mode = 0; mode < limits.size(); ++mode)
    if (mean < limits[mode]) return static_cast<int>(mode) + 1;
  return std::min(largest_mode, 7 + std::max(0, static_cast<int>(std::bit_width(mean)) - 9));
}

void add_blocks(const PolyphasePlanes& planes, int plane, int first_column,
                std::vector<ResidualBlock>& blocks) {
  const int columns = std::min(block_columns, planes.columns(plane) - first_column);
  // Whole vectors of particles.
  const int length = columns > 2 ? block_particles / block_columns : block_particles / columns;
  for (int a = 0; a < planes.rows(plane); a += length)
    blocks.push_back({planes.cell(plane, a, first_column), static_cast<std::size_t>(columns),
                      static_cast<std::size_t>(std::min(length, planes.rows(plane) - a))});
}

// The residuals of a block of one component.
struct ResidualSummary {
  std::uint64_t sum = 0;
  std::uint32_t largest = 0;
};
ResidualSummary summary_of(const std::uint32_t* residuals, const ResidualBlock& block,
                           std::size_t stride) {
  ResidualSummary summary;
  for (std::size_t b = 0; b < block.columns; ++b)
    for (std::size_t k = 0; k < block.length; ++k) {
      summary.sum += residuals[b * stride + k];
      summary.largest = std::max(summary.largest, residuals[b * stride + k]);
    }
  return summary;
}

template <int per_byte>
void put_symbols(const std::uint32_t* residuals, std::size_t length, const CodingMode& mode,
                 unsigned char* symbols) {
  for (std::size_t k = 0; k < length; k += per_byte) {
    std::uint32_t byte = 0;
    for (int part = 0; part < per_byte; ++part)
      if (const std::size_t at = k + part; at < length)
        byte |= std::min(residuals[at] >> mode.low_bits, mode.escape) << (8 / per_byte * part);
    *symbols++ = static_cast<unsigned char>(byte);
  }
}

// Packs the symbols of a column of a block.
void put_symbols(const std::uint32_t* residuals, std::size_t length, const CodingMode& mode,
                 std::string& symbols) {
  const std::size_t begin = symbols.size();
  symbols.resize(begin + mode.column_bytes(length));
  auto* out = reinterpret_cast<unsigned char*>(symbols.data() + begin);
  if (mode.symbols_per_byte == 4) return put_symbols<4>(residuals, length, mode, out);
  if (mode.symbols_per_byte == 2) return put_symbols<2>(residuals, length, mode, out);
  put_symbols<1>(residuals, length, mode, out);
}

// What symbols cannot hold.
void put_rest(const std::uint32_t* residuals, std::size_t length, const CodingMode& mode,
              std::string& escapes, BitPacker& low_bits) {
  for (std::size_t k = 0; k < length; ++k) {
    const std::uint32_t high = residuals[k] >> mode.low_bits;
    if (high >= mode.escape) put_varint(escapes, high - mode.escape);
    if (mode.low_bits > 0) low_bits.put_bits(residuals[k], mode.low_bits);
  }
}

// From the mode of the block before: nearly always a small step.
unsigned char mode_step(int mode, int before) {
  return static_cast<unsigned char>(zigzag(mode - before));
}

}  // namespace

std::vector<ResidualBlock> residual_blocks(const PolyphasePlanes& planes) {
  std::vector<ResidualBlock> blocks;
  for (const int plane : PolyphasePlanes::order)
    for (int b = 0; b < planes.columns(plane); b += block_columns)
      add_blocks(planes, plane, b, blocks);
  return blocks;
}

std::vector<unsigned char> symbols_of(std::size_t kind) {
  if (kind == mode_kind) {
    std::vector<unsigned char> steps;
    for (int step = -largest_mode; step <= largest_mode; ++step)
      steps.push_back(mode_step(step, 0));
    return steps;
  }
  const CodingMode& mode = first_modes[kind];
  std::vector<unsigned char> symbols = {0};
  for (int part = 0; part < mode.symbols_per_byte; ++part) {
    const std::vector<unsigned char> before = symbols;
    for (std::uint32_t symbol = 1; symbol <= mode.escape; ++symbol)
      for (const unsigned char rest : before)
        symbols.push_back(static_cast<unsigned char>(rest | symbol << (mode.symbol_bits() * part)));
  }
  return symbols;
}

void ResidualPacker::append(const Residuals& residuals, std::string& bytes) {
  for (std::string& run : runs_) run.clear();
  std::string escapes;
  BitPacker low_bits;
  for (const auto& component : residuals) {
    int before = 0;
    for (const ResidualBlock& block : blocks_) {
      const std::uint32_t* first = component.data() + block.cell;
      const ResidualSummary summary = summary_of(first, block, stride_);
      const int number = mode_for(summary.sum, block.particles());
      runs_[mode_kind].push_back(static_cast<char>(mode_step(number, before)));
      before = number;
      if (number == 0) continue;
      const CodingMode& mode = mode_of(number);
      for (std::size_t b = 0; b < block.columns; ++b)
        put_symbols(first + b * stride_, block.length, mode, runs_[mode.kind]);
      if (mode.low_bits == 0 && summary.largest < mode.escape) continue;
      for (std::size_t b = 0; b < block.columns; ++b)
        put_rest(first + b * stride_, block.length, mode, escapes, low_bits);
    }
  }
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind)
    compressor_.append(kind, runs_[kind], bytes);
  bytes += escapes;
  bytes += low_bits.finish();
}

ResidualUnpacker::ResidualUnpacker(const PolyphasePlanes& planes,
                                   std::span<const std::string> entropy_tables)
    : cells_(planes.cells()),
      stride_(planes.stride()),
      decompressor_(entropy_tables),
      blocks_(residual_blocks(planes)) {}

bool ResidualUnpacker::take_modes(std::string_view& bytes) {
  modes_.resize(3 * blocks_.size());
  if (!decompressor_.take(mode_kind, bytes, modes_.size(), modes_.data())) return false;
  for (std::size_t component = 0; component < 3; ++component) {
    int before = 0;
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
      unsigned char& mode = modes_[component * blocks_.size() + block];
      before += unzigzag(mode);
      if (before < 0 || before > largest_mode) return false;
      mode = static_cast<unsigned char>(before);
    }
  }
  return true;
}

bool ResidualUnpacker::take_symbols(std::string_view& bytes) {
  std::array<std::size_t, symbol_kinds> sizes{};
  for (std::size_t block = 0; block < modes_.size(); ++block)
    if (modes_[block] > 0) {
      const CodingMode& mode = mode_of(modes_[block]);
      sizes[mode.kind] += mode.bytes(blocks_[block % blocks_.size()]);
    }
  for (std::size_t kind = 1; kind < symbol_kinds; ++kind) {
    symbols_[kind].resize(sizes[kind] + PolyphasePlanes::lane_quantum);  // whole vectors are read
    if (!decompressor_.take(kind, bytes, sizes[kind], symbols_[kind].data())) return false;
  }
  return true;
}

namespace {

bool take_escapes(std::string_view& bytes, std::uint32_t escape, std::size_t count,
                  std::uint32_t* residuals) {
  for (std::size_t k = 0; k < count; ++k) {
    if (residuals[k] < escape) continue;
    const auto more = take_varint(bytes);
    if (!more || *more > std::numeric_limits<std::uint32_t>::max() - residuals[k]) return false;
    residuals[k] += *more;
  }
  return true;
}

}  // namespace

bool ResidualUnpacker::spread_symbols(std::string_view& bytes, Residuals& residuals) const {
  std::array<const unsigned char*, symbol_kinds> next{};
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind) next[kind] = symbols_[kind].data();
  const unsigned char* number = modes_.data();
  const auto spread = loops().spread;
  for (auto& component : residuals) {
    component.resize(cells_);
    for (const ResidualBlock& block : blocks_) {
      const CodingMode& mode = mode_of(*number++);
      std::uint32_t* first = component.data() + block.cell;
      if (mode.kind == 0) {
        for (std::size_t b = 0; b < block.columns; ++b)
          std::fill_n(first + b * stride_, block.length, 0U);
        continue;
      }
      const bool escapes = spread(mode.symbol_bits(), mode.escape, next[mode.kind], block.columns,
                                  block.length, stride_, first);
      next[mode.kind] += mode.bytes(block);
      for (std::size_t b = 0; escapes && b < block.columns; ++b)
        if (!take_escapes(bytes, mode.escape, block.length, first + b * stride_)) return false;
    }
  }
  return true;
}

bool ResidualUnpacker::add_low_bits(std::string_view bytes, Residuals& residuals) const {
  std::uint64_t count = 0;
  for (std::size_t block = 0; block < modes_.size(); ++block)
    count += static_cast<std::uint64_t>(mode_of(modes_[block]).low_bits) *
             blocks_[block % blocks_.size()].particles();
  if (bytes.size() != (count + 7) / 8) return false;
  if (count == 0) return true;
  BitTaker low_bits(bytes);
  const unsigned char* number = modes_.data();
  for (auto& component : residuals)
    for (const ResidualBlock& block : blocks_) {
      const int bits = mode_of(*number++).low_bits;
      if (bits == 0) continue;
      for (std::size_t b = 0; b < block.columns; ++b)
        for (std::size_t k = 0; k < block.length; ++k) {
          std::uint32_t& residual = component[block.cell + b * stride_ + k];
          if (std::uint64_t{residual} >> (32 - bits) != 0) return false;
          residual = (residual << bits) | low_bits.take_bits(bits);
        }
    }
  return true;
}

bool ResidualUnpacker::unpack(std::string_view bytes, Residuals& residuals) {
  return take_modes(bytes) && take_symbols(bytes) && spread_symbols(bytes, residuals) &&
         add_low_bits(bytes, residuals);
}

}  // namespace ribbon
