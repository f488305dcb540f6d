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
// Also the length of what shares a table of symbols: the bytes of a state, whose lowest are noise
// and whose highest are nearly all alike, need one for each kind.
constexpr int block_log = 14;

// Above every window that this level uses; a file that asks for more memory is not one of ours.
constexpr int largest_window_log = 23;

}  // namespace

void FreeContext::operator()(ZSTD_CCtx* context) const {
  ZSTD_freeCCtx(context);
}
void FreeContext::operator()(ZSTD_DCtx* context) const {
  ZSTD_freeDCtx(context);
}

Compressor::Compressor() : context_(ZSTD_createCCtx()) {
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_contentSizeFlag, 0);
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_minMatch, shortest_match);
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_hashLog, match_table_log);
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_windowLog, block_log);
}

std::string Compressor::compress(std::string_view content) {
  std::string bytes(ZSTD_compressBound(content.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context_.get(), bytes.data(), bytes.size(), content.data(), content.size());
  assert(ZSTD_isError(size) == 0);  // the room is enough for the worst case
  bytes.resize(size);
  return bytes;
}

Decompressor::Decompressor() : context_(ZSTD_createDCtx()) {
  ZSTD_DCtx_setParameter(context_.get(), ZSTD_d_windowLogMax, largest_window_log);
}

std::optional<std::string_view> Decompressor::decompress(std::string_view bytes,
                                                         std::size_t limit) {
  ZSTD_DCtx_reset(context_.get(), ZSTD_reset_session_only);
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t filled = 0;
  while (true) {
    // One byte more than allowed, so that a frame that holds too much is noticed.
    if (filled == content_.size())
      content_.resize(std::min(limit + 1, std::max<std::size_t>(2 * content_.size(), 1 << 16)));
    if (filled > limit) return std::nullopt;
    ZSTD_outBuffer out{content_.data(), content_.size(), filled};
    const std::size_t left = ZSTD_decompressStream(context_.get(), &out, &in);
    const bool stuck = in.pos == in.size && out.pos < out.size;
    filled = out.pos;
    if (ZSTD_isError(left) != 0) return std::nullopt;
    if (left == 0) break;
    if (stuck) return std::nullopt;  // cut off
  }
  if (in.pos != in.size || filled > limit) return std::nullopt;
  return std::string_view(content_).substr(0, filled);
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

SymbolCompressor::SymbolCompressor() : context_(ZSTD_createCCtx()) {
  ZSTD_CCtx* context = context_.get();
  // Entropy coding alone: this level looks for no repetitions, which it takes for a reason not to
  // code literals either, unless told.
  ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, ZSTD_minCLevel());
  ZSTD_CCtx_setParameter(context, ZSTD_c_literalCompressionMode, ZSTD_ps_enable);
  ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, window_log);
  ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
}

void SymbolCompressor::append(std::span<const unsigned char> symbols, std::string& to) {
  if (symbols.empty()) return;
  packed_.resize(ZSTD_compressBound(symbols.size()));
  const std::size_t size = ZSTD_compress2(context_.get(), packed_.data(), packed_.size(),
                                          symbols.data(), symbols.size());
  assert(ZSTD_isError(size) == 0 && packed_.starts_with(frame_start));
  const std::size_t kept = size - frame_start.size();
  const bool is_worth_it = kept < symbols.size() - symbols.size() / least_share_saved;
  put_varint(to, is_worth_it ? static_cast<std::uint32_t>(kept) : 0);
  if (is_worth_it)
    to.append(packed_, frame_start.size(), kept);
  else
    to.append(symbols.begin(), symbols.end());
}

SymbolDecompressor::SymbolDecompressor() : context_(ZSTD_createDCtx()) {}

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
  packed_.assign(frame_start).append(run);
  if (ZSTD_findFrameCompressedSize(packed_.data(), packed_.size()) != packed_.size()) return false;
  return ZSTD_decompressDCtx(context_.get(), symbols.data(), symbols.size(), packed_.data(),
                             packed_.size()) == symbols.size();
}

}  // namespace ribbon
