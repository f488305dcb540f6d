#include "recording/symbol_compression.h"

#include <zstd.h>

#include <cassert>
#include <cstdint>
#include <cstring>

#include "recording/varint.h"

namespace ribbon {

namespace {

// Every zstd frame here begins with these bytes (no content size, no checksum, no dictionary's
// name), so they are not recorded.
constexpr std::string_view frame_start{"\x28\xB5\x2F\xFD\x00", 5};

// Symbols are mostly noise: matches in them are accidents that cost more than they save. A tiny
// match finder leaves those that are real, such as a ribbon at rest.
constexpr int level = 1;
constexpr int window_log = 17;
constexpr int shortest_match = 7;
constexpr int match_table_log = 6;

struct Free {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
  void operator()(ZSTD_CDict* table) const { ZSTD_freeCDict(table); }
  void operator()(ZSTD_DDict* table) const { ZSTD_freeDDict(table); }
};

}  // namespace

struct SymbolCompressor::State {
  std::vector<std::unique_ptr<ZSTD_CCtx, Free>> contexts;  // by kind, the last without a table
  std::string packed;
};

SymbolCompressor::SymbolCompressor(std::span<const std::string> tables)
    : state_(std::make_unique<State>()) {
  for (std::size_t kind = 0; kind <= tables.size(); ++kind) {
    state_->contexts.emplace_back(ZSTD_createCCtx());
    ZSTD_CCtx* context = state_->contexts.back().get();
    ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, window_log);
    ZSTD_CCtx_setParameter(context, ZSTD_c_minMatch, shortest_match);
    ZSTD_CCtx_setParameter(context, ZSTD_c_hashLog, match_table_log);
    ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
    ZSTD_CCtx_setParameter(context, ZSTD_c_dictIDFlag, 0);
    if (kind < tables.size())
      ZSTD_CCtx_loadDictionary(context, tables[kind].data(), tables[kind].size());
  }
}
SymbolCompressor::SymbolCompressor(SymbolCompressor&&) noexcept = default;
SymbolCompressor& SymbolCompressor::operator=(SymbolCompressor&&) noexcept = default;
SymbolCompressor::~SymbolCompressor() = default;

void SymbolCompressor::append(std::size_t kind, std::string_view symbols, std::string& bytes) {
  if (symbols.empty()) return;
  std::string& packed = state_->packed;
  packed.resize(ZSTD_compressBound(symbols.size()));
  ZSTD_CCtx* context = state_->contexts[std::min(kind, state_->contexts.size() - 1)].get();
  const std::size_t size =
      ZSTD_compress2(context, packed.data(), packed.size(), symbols.data(), symbols.size());
  assert(ZSTD_isError(size) == 0 && packed.starts_with(frame_start));
  const std::size_t kept = size - frame_start.size();
  if (kept < symbols.size()) {
    put_varint(bytes, static_cast<std::uint32_t>(kept));
    bytes.append(packed, frame_start.size(), kept);
  } else {
    put_varint(bytes, 0);
    bytes += symbols;
  }
}

struct SymbolDecompressor::State {
  std::unique_ptr<ZSTD_DCtx, Free> context{ZSTD_createDCtx()};
  std::vector<std::unique_ptr<ZSTD_DDict, Free>> tables;
  std::string packed{frame_start};
};

SymbolDecompressor::SymbolDecompressor(std::span<const std::string> tables)
    : state_(std::make_unique<State>()) {
  for (const std::string& table : tables)
    state_->tables.emplace_back(ZSTD_createDDict(table.data(), table.size()));
}
SymbolDecompressor::SymbolDecompressor(SymbolDecompressor&&) noexcept = default;
SymbolDecompressor& SymbolDecompressor::operator=(SymbolDecompressor&&) noexcept = default;
SymbolDecompressor::~SymbolDecompressor() = default;

bool SymbolDecompressor::take(std::size_t kind, std::string_view& bytes, std::size_t count,
                              unsigned char* symbols) {
  if (count == 0) return true;
  const auto size = take_varint(bytes);
  if (!size) return false;
  const std::size_t taken = *size == 0 ? count : *size;
  if (taken > bytes.size()) return false;
  const std::string_view run = bytes.substr(0, taken);
  bytes.remove_prefix(taken);
  if (*size == 0) {
    std::memcpy(symbols, run.data(), count);
    return true;
  }
  std::string& packed = state_->packed;
  packed.resize(frame_start.size());
  packed += run;
  const ZSTD_DDict* table = kind < state_->tables.size() ? state_->tables[kind].get() : nullptr;
  return ZSTD_decompress_usingDDict(state_->context.get(), symbols, count, packed.data(),
                                    packed.size(), table) == count;
}

}  // namespace ribbon
