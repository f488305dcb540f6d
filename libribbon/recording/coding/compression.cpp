#include "recording/coding/compression.h"

#define ZSTD_STATIC_LINKING_ONLY  // for ZSTD_c_literalCompressionMode; zstd is linked statically
#include <zstd.h>

#include <algorithm>
#include <array>
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

// zstd prefers a table that it has to a better one for runs that are no longer.
constexpr std::size_t short_run = 1024;

using namespace std::string_view_literals;

// A zstd dictionary for each kind of run (FORMAT.md, section 8.5) is these three parts: trees tell
// the symbols' lengths, as zstd writes them. They were made of ribbons of 8 x 400 particles.
constexpr std::string_view dictionary_start = "\x37\xA4\x30\xEC\x01\0\0\0"sv;
constexpr std::array<std::string_view, 4> trees = {
    "\x18\x10\xD8\x41\x0A\x69\x0D\x0C\xC3\x30\x0C\xC3\x30\x0C\x03\x8E\x74\x57\x08\xAC\xDA\xE4"
    "\x2D\xBE\x77"sv,
    "\x41\x10\xA0\x44\x93\x34\x06\x40\x0C\x69\x85\xF2\x70\xE1\x25\x81\x8D\x1B\xC8\x89\x07\x0C"
    "\xEB\xA2\x5F\x07\x73\x14\x45\xD1\x17\x5B\x42\x94\x2F\x64\xC1\x30\xE6\x40\xBB\x7A\x18\x60"
    "\x5F\x46\x2A\x62\x0D\x90\x75\xF1\x79\x60\x25\x81\x69\x67\x74\x6B\xAC\x65\x54\x59\x5B\x0A"sv,
    "\x4A\x10\x88\x55\x9B\x74\xD4\x20\x37\xDA\x96\xC4\x07\xF4\x20\xB2\xF4\x6D\x49\x34\xD6\x46"
    "\xF0\x31\xE4\xFB\x4C\x3C\x87\x34\x87\x71\xD9\x04\x00\x00\x00\x00\x00\x00\x54\x45\xE0\x1D"
    "\x52\x2B\x9F\xC0\xB0\x29\xB8\xF4\x7D\xC8\x52\xFB\x6B\xA3\x0F\xD0\xF8\x44\xDA\xD2\x8B\x3B"
    "\x9F\xEC\x2D\x7C\x84\xA7\xDB\x4E\x01"sv,
    "\x3E\x10\xB0\x34\x49\x3A\x72\xEF\x4D\x08\x21\xA4\xB5\xD6\xAC\xB5\x66\xFF\xFF\xFF\xFF\xFF"
    "\x5B\xC4\x16\xB1\x09\x82\x20\x08\x82\x20\x08\x82\x20\x08\x82\x20\x88\x63\x6C\x11\x5B\xC4"
    "\x16\x31\x8F\x8F\x8F\x1F\x59\x6B\xAD\xB5\xAD\xB5\x46\x08\x21\x64\x6F\x29\x53"sv};
constexpr std::string_view dictionary_end =
    "\x10\x3F\x10\x3F\x10\x3F\x01\0\0\0\x04\0\0\0\x08\0\0\0\0\0\0\0\0\0\0\0"sv;

std::string dictionary(std::string_view tree) {
  return std::string(dictionary_start).append(tree).append(dictionary_end);
}

}  // namespace

void FreeDictionary::operator()(ZSTD_DDict_s* dictionary) const {
  ZSTD_freeDDict(dictionary);
}

namespace {

CompressionContext symbol_context() {
  CompressionContext owned(ZSTD_createCCtx());
  ZSTD_CCtx* context = owned.get();
  // Entropy coding alone: this level looks for no repetitions, which it takes for a reason not to
  // code literals either, unless told.
  ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, ZSTD_minCLevel());
  ZSTD_CCtx_setParameter(context, ZSTD_c_literalCompressionMode, ZSTD_ps_enable);
  ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, window_log);
  ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
  ZSTD_CCtx_setParameter(context, ZSTD_c_dictIDFlag, 0);
  return owned;
}

// Without frame_start.
void compress(ZSTD_CCtx* context, std::span<const unsigned char> symbols, std::string& packed) {
  packed.resize(ZSTD_compressBound(symbols.size()));
  packed.resize(
      ZSTD_compress2(context, packed.data(), packed.size(), symbols.data(), symbols.size()));
  assert(packed.starts_with(frame_start));
  packed.erase(0, frame_start.size());
}

bool saves_enough(std::size_t size, std::size_t other) {
  return size < other - other / least_share_saved;
}

}  // namespace

SymbolCompressor::SymbolCompressor() : with_own_table_(symbol_context()) {
  for (std::size_t kind = 0; kind < trees.size(); ++kind) {
    contexts_[kind] = symbol_context();
    const std::string known = dictionary(trees[kind]);
    ZSTD_CCtx_loadDictionary_advanced(contexts_[kind].get(), known.data(), known.size(),
                                      ZSTD_dlm_byCopy, ZSTD_dct_fullDict);
  }
}

void SymbolCompressor::append(std::size_t kind, std::span<const unsigned char> symbols,
                              std::string& to) {
  if (symbols.empty()) return;
  compress(contexts_[kind].get(), symbols, packed_);
  if (symbols.size() <= short_run) {
    compress(with_own_table_.get(), symbols, other_);
    if (saves_enough(other_.size(), packed_.size())) packed_.swap(other_);
  }
  const bool is_worth_it = saves_enough(packed_.size(), symbols.size());
  put_varint(to, is_worth_it ? static_cast<std::uint32_t>(packed_.size()) : 0);
  if (is_worth_it)
    to.append(packed_);
  else
    to.append(symbols.begin(), symbols.end());
}

SymbolDecompressor::SymbolDecompressor() : context_(ZSTD_createDCtx()) {
  for (std::size_t kind = 0; kind < trees.size(); ++kind) {
    const std::string known = dictionary(trees[kind]);
    dictionaries_[kind].reset(ZSTD_createDDict_advanced(known.data(), known.size(), ZSTD_dlm_byCopy,
                                                        ZSTD_dct_fullDict, ZSTD_defaultCMem));
  }
}

bool SymbolDecompressor::take(std::size_t kind, std::string_view& from,
                              std::span<unsigned char> symbols) {
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
  return ZSTD_decompress_usingDDict(context_.get(), symbols.data(), symbols.size(), packed_.data(),
                                    packed_.size(), dictionaries_[kind].get()) == symbols.size();
}

}  // namespace ribbon
