#include "recording/coding/compression.h"

#define ZSTD_STATIC_LINKING_ONLY  // for ZSTD_c_literalCompressionMode; zstd is linked statically
#include <zstd.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstring>

#include "recording/coding/varint.h"

namespace ribbon {

namespace {

// What is compressed here is mostly noise. Its entropy coding is all the gain there is; repetitions
// are accidents whose description costs more than it saves. Long matches only and a tiny table
// leave those that are real, such as a ribbon at rest.
constexpr int level = 1;
constexpr int shortest_match = 7;
constexpr int match_table_log = 6;

// Above every window that this level uses; a file that asks for more memory is not one of ours.
constexpr int largest_window_log = 23;

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

}  // namespace

struct Compressor::State {
  std::unique_ptr<ZSTD_CCtx, FreeContext> context{ZSTD_createCCtx()};
};

Compressor::Compressor() : state_(std::make_unique<State>()) {
  ZSTD_CCtx_setParameter(state_->context.get(), ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(state_->context.get(), ZSTD_c_contentSizeFlag, 0);
  ZSTD_CCtx_setParameter(state_->context.get(), ZSTD_c_minMatch, shortest_match);
  ZSTD_CCtx_setParameter(state_->context.get(), ZSTD_c_hashLog, match_table_log);
}
Compressor::Compressor(Compressor&&) noexcept = default;
Compressor& Compressor::operator=(Compressor&&) noexcept = default;
Compressor::~Compressor() = default;

std::string Compressor::compress(std::string_view content) {
  std::string bytes(ZSTD_compressBound(content.size()), '\0');
  const std::size_t size = ZSTD_compress2(state_->context.get(), bytes.data(), bytes.size(),
                                          content.data(), content.size());
  assert(ZSTD_isError(size) == 0);  // the room is enough for the worst case
  bytes.resize(size);
  return bytes;
}

struct Decompressor::State {
  std::unique_ptr<ZSTD_DCtx, FreeContext> context{ZSTD_createDCtx()};
  std::string content;
};

Decompressor::Decompressor() : state_(std::make_unique<State>()) {
  ZSTD_DCtx_setParameter(state_->context.get(), ZSTD_d_windowLogMax, largest_window_log);
}
Decompressor::Decompressor(Decompressor&&) noexcept = default;
Decompressor& Decompressor::operator=(Decompressor&&) noexcept = default;
Decompressor::~Decompressor() = default;

std::optional<std::string_view> Decompressor::decompress(std::string_view bytes,
                                                         std::size_t limit) {
  std::string& content = state_->content;
  ZSTD_DCtx_reset(state_->context.get(), ZSTD_reset_session_only);
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t filled = 0;
  while (true) {
    // One byte more than allowed, so that a frame that holds too much is noticed.
    if (filled == content.size())
      content.resize(std::min(limit + 1, std::max<std::size_t>(2 * content.size(), 1 << 16)));
    if (filled > limit) return std::nullopt;
    ZSTD_outBuffer out{content.data(), content.size(), filled};
    const std::size_t left = ZSTD_decompressStream(state_->context.get(), &out, &in);
    const bool stuck = in.pos == in.size && out.pos < out.size;
    filled = out.pos;
    if (ZSTD_isError(left) != 0) return std::nullopt;
    if (left == 0) break;
    if (stuck) return std::nullopt;  // cut off
  }
  if (in.pos != in.size || filled > limit) return std::nullopt;
  return std::string_view(content).substr(0, filled);
}

namespace {

// Every zstd frame here begins with these bytes (no content size, no checksum, no dictionary's
// name), so they are not recorded.
constexpr std::string_view frame_start{"\x28\xB5\x2F\xFD\x00", 5};

// Fixed, so that equal runs give equal bytes however long they are.
constexpr int window_log = 17;

// A run is coded where that saves more than this part of it: decoding takes longer than all else
// that is done with a symbol.
constexpr std::size_t least_share_saved = 16;

}  // namespace

struct SymbolCompressor::State {
  std::unique_ptr<ZSTD_CCtx, FreeContext> context{ZSTD_createCCtx()};
  std::string packed;
};

SymbolCompressor::SymbolCompressor() : state_(std::make_unique<State>()) {
  ZSTD_CCtx* context = state_->context.get();
  // Entropy coding alone: this level looks for no repetitions, which it takes for a reason not to
  // code literals either, unless told.
  ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, ZSTD_minCLevel());
  ZSTD_CCtx_setParameter(context, ZSTD_c_literalCompressionMode, ZSTD_ps_enable);
  ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, window_log);
  ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
}
SymbolCompressor::SymbolCompressor(SymbolCompressor&&) noexcept = default;
SymbolCompressor& SymbolCompressor::operator=(SymbolCompressor&&) noexcept = default;
SymbolCompressor::~SymbolCompressor() = default;

void SymbolCompressor::append(std::span<const unsigned char> symbols, std::string& to) {
  if (symbols.empty()) return;
  std::string& packed = state_->packed;
  packed.resize(ZSTD_compressBound(symbols.size()));
  const std::size_t size = ZSTD_compress2(state_->context.get(), packed.data(), packed.size(),
                                          symbols.data(), symbols.size());
  assert(ZSTD_isError(size) == 0 && packed.starts_with(frame_start));
  const std::size_t kept = size - frame_start.size();
  const bool is_worth_it = kept < symbols.size() - symbols.size() / least_share_saved;
  put_varint(to, is_worth_it ? static_cast<std::uint32_t>(kept) : 0);
  if (is_worth_it)
    to.append(packed, frame_start.size(), kept);
  else
    to.append(symbols.begin(), symbols.end());
}

struct SymbolDecompressor::State {
  std::unique_ptr<ZSTD_DCtx, FreeContext> context{ZSTD_createDCtx()};
  std::string packed{frame_start};
};

SymbolDecompressor::SymbolDecompressor() : state_(std::make_unique<State>()) {}
SymbolDecompressor::SymbolDecompressor(SymbolDecompressor&&) noexcept = default;
SymbolDecompressor& SymbolDecompressor::operator=(SymbolDecompressor&&) noexcept = default;
SymbolDecompressor::~SymbolDecompressor() = default;

bool SymbolDecompressor::take(std::string_view& from, std::span<unsigned char> symbols) {
  if (symbols.empty()) return true;
  const auto size = take_varint(from);
  if (!size) return false;
  const std::size_t taken = *size == 0 ? symbols.size() : *size;
  if (taken > from.size()) return false;
  const std::string_view run = from.substr(0, taken);
  from.remove_prefix(taken);
  if (*size == 0) {
    std::memcpy(symbols.data(), run.data(), run.size());
    return true;
  }
  std::string& packed = state_->packed;
  packed.resize(frame_start.size());
  packed += run;
  if (ZSTD_findFrameCompressedSize(packed.data(), packed.size()) != packed.size()) return false;
  return ZSTD_decompressDCtx(state_->context.get(), symbols.data(), symbols.size(), packed.data(),
                             packed.size()) == symbols.size();
}

}  // namespace ribbon
