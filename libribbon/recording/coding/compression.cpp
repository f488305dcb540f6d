#include "recording/coding/compression.h"

#define ZSTD_STATIC_LINKING_ONLY  // for formats and literals; zstd is linked statically
#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <cassert>
#include <new>

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

// What zstd has made, or, as everywhere else, an exception where there is no memory for it.
template <class Made>
Made* made(Made* pointer) {
  if (pointer == nullptr) throw std::bad_alloc();
  return pointer;
}

// The size that zstd answers with, or another error than that there is no memory.
std::size_t answered(std::size_t size) {
  if (ZSTD_getErrorCode(size) == ZSTD_error_memory_allocation) throw std::bad_alloc();
  return size;
}

}  // namespace

void FreeContext::operator()(ZSTD_CCtx* context) const {
  ZSTD_freeCCtx(context);
}
void FreeContext::operator()(ZSTD_DCtx* context) const {
  ZSTD_freeDCtx(context);
}

Compressor::Compressor() : context_(made(ZSTD_createCCtx())) {
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_contentSizeFlag, 0);
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_minMatch, shortest_match);
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_hashLog, match_table_log);
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_windowLog, block_log);
}

std::string Compressor::compress(std::string_view content) {
  std::string bytes(ZSTD_compressBound(content.size()), '\0');
  const std::size_t size = answered(
      ZSTD_compress2(context_.get(), bytes.data(), bytes.size(), content.data(), content.size()));
  assert(ZSTD_isError(size) == 0);  // the room is enough for the worst case
  bytes.resize(size);
  return bytes;
}

Decompressor::Decompressor() : context_(made(ZSTD_createDCtx())) {
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
    const std::size_t left = answered(ZSTD_decompressStream(context_.get(), &out, &in));
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

// Fixed, so that equal runs give equal bytes however long they are.
constexpr int window_log = 17;

// A run is coded where that saves more than this part of it: decoding takes longer than all else
// that is done with a symbol.
constexpr std::size_t least_share_saved = 16;

// zstd prefers a table that it has to a better one for runs that are no longer.
constexpr std::size_t short_run = 1024;

// The context that has no table.
constexpr std::size_t knows_none = symbol_kinds;

using namespace std::string_view_literals;

// A zstd dictionary for each kind of run (FORMAT.md, section 8.5) is these three parts: trees tell
// the symbols' lengths, as zstd writes them. They were made of ribbons of 8 x 400 particles.
constexpr std::string_view dictionary_start = "\x37\xA4\x30\xEC\x01\0\0\0"sv;
constexpr std::array<std::string_view, symbol_kinds> trees = {
    "\x2B\x10\xC8\x92\x24\xAD\x01\xFF\xFF\xFF\xFF\xFF\xFF\x9F\xBF\x02\xFC\xFF\x37\xA0\xDF\x5A"
    "\xAB\xF8\x7C\xDB\x6C\x74\x00\x59\xDB\xB0\xE0\x6F\x1B\x81\x33\xA0\x6F\xE5\x51\xE6\x26\x01"sv,
    "\x3F\x10\xA0\x44\x93\x34\x06\x40\x0C\x55\x84\xB7\xE8\xEA\x18\x03\x69\x0D\x74\x87\x01\xC3"
    "\xBA\xF8\x0C\xC3\x30\x0C\xC3\x1D\xF8\xB4\x3E\x0E\x59\x90\x41\x07\xDA\xD5\xC3\x00\xFB\x82"
    "\x52\x11\x6B\x80\xAC\x8B\xCF\x03\x2B\x21\xEA\x9F\xD1\xAD\xB1\x96\x51\x65\x6D\x29"sv,
    "\x4E\x10\x78\x47\xD4\x74\x44\x11\x41\x6D\x57\x5A\x2D\xF6\xA9\x5D\xF2\xCD\x20\x7F\xDE\x00"
    "\xD5\x60\xD6\x0A\x0E\x56\x41\xA9\x03\xEB\x8F\x19\x6B\x4B\x85\x27\x9B\xC8\x26\x2C\x07\x8A"
    "\x7B\x3C\x29\x6C\xBA\x47\xFE\x0E\xB3\xC8\x02\xEE\xDF\xF1\x61\x40\x6A\x6B\xB1\xAE\xDF\x8D"
    "\x16\x86\x53\xFD\xB6\x57\xC2\x65\x79\x63\xD8\x9D\x02"sv};
constexpr std::string_view dictionary_end =
    "\x10\x3F\x10\x3F\x10\x3F\x01\0\0\0\x04\0\0\0\x08\0\0\0\0\0\0\0\0\0\0\0"sv;

std::string dictionary(std::string_view tree) {
  return std::string(dictionary_start).append(tree).append(dictionary_end);
}

bool saves_enough(std::size_t size, std::size_t other) {
  return size < other - other / least_share_saved;
}

}  // namespace

void SymbolDecompressor::FreeDictionary::operator()(ZSTD_DDict_s* dictionary) const {
  ZSTD_freeDDict(dictionary);
}

SymbolCompressor::SymbolCompressor() {
  for (CompressionContext& owned : contexts_) {
    ZSTD_CCtx* context = made(ZSTD_createCCtx());
    owned.reset(context);
    // Entropy coding alone: this level looks for no repetitions, which it takes for a reason not to
    // code literals either, unless told.
    ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, ZSTD_minCLevel());
    ZSTD_CCtx_setParameter(context, ZSTD_c_literalCompressionMode, ZSTD_ps_enable);
    ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, window_log);
    ZSTD_CCtx_setParameter(context, ZSTD_c_format, ZSTD_f_zstd1_magicless);
    ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
    ZSTD_CCtx_setParameter(context, ZSTD_c_dictIDFlag, 0);
  }
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind) {
    const std::string known = dictionary(trees[kind]);
    answered(ZSTD_CCtx_loadDictionary_advanced(contexts_[kind].get(), known.data(), known.size(),
                                               ZSTD_dlm_byCopy, ZSTD_dct_fullDict));
  }
}

// The run by the context of its kind, or by the one that knows none, in packed_.
std::string_view SymbolCompressor::packed(std::size_t kind, std::span<const unsigned char> run) {
  std::string& to = packed_[kind == knows_none ? 1 : 0];
  to.resize(ZSTD_compressBound(run.size()));
  return {to.data(), answered(ZSTD_compress2(contexts_[kind].get(), to.data(), to.size(),
                                             run.data(), run.size()))};
}

void SymbolCompressor::append(std::size_t kind, std::span<const unsigned char> symbols,
                              std::string& to) {
  if (symbols.empty()) return;
  std::string_view chosen = packed(kind, symbols);
  if (symbols.size() <= short_run)
    if (const std::string_view other = packed(knows_none, symbols);
        saves_enough(other.size(), chosen.size()))
      chosen = other;
  if (saves_enough(chosen.size(), symbols.size())) return put_string(to, chosen);
  put<std::uint32_t>(to, 0);
  to.append(symbols.begin(), symbols.end());
}

SymbolDecompressor::SymbolDecompressor() : context_(made(ZSTD_createDCtx())) {
  ZSTD_DCtx_setParameter(context_.get(), ZSTD_d_format, ZSTD_f_zstd1_magicless);
  for (std::size_t kind = 0; kind < trees.size(); ++kind) {
    const std::string known = dictionary(trees[kind]);
    dictionaries_[kind].reset(made(ZSTD_createDDict_advanced(
        known.data(), known.size(), ZSTD_dlm_byCopy, ZSTD_dct_fullDict, ZSTD_defaultCMem)));
  }
}

bool SymbolDecompressor::take(std::size_t kind, ByteTaker& from, std::span<unsigned char> symbols) {
  if (symbols.empty()) return true;
  const auto size = from.take<std::uint32_t>();
  const std::string_view run = from.take_bytes(size == 0 ? symbols.size() : size);
  if (!from.complete()) return false;
  if (size == 0) {
    std::copy(run.begin(), run.end(), symbols.begin());
    return true;
  }
  return ZSTD_decompress_usingDDict(context_.get(), symbols.data(), symbols.size(), run.data(),
                                    run.size(), dictionaries_[kind].get()) == symbols.size();
}

}  // namespace ribbon
