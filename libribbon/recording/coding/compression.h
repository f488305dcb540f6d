// zstd, for everything in a recording that is not a plain number.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "recording/coding/bytes.h"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;
struct ZSTD_DDict_s;

namespace ribbon {

struct FreeContext {
  void operator()(ZSTD_CCtx_s* context) const;
  void operator()(ZSTD_DCtx_s* context) const;
};
using CompressionContext = std::unique_ptr<ZSTD_CCtx_s, FreeContext>;
using DecompressionContext = std::unique_ptr<ZSTD_DCtx_s, FreeContext>;

// Keeps its working memory between calls. Equal input gives equal bytes.
class Compressor {
 public:
  Compressor();

  // One zstd frame.
  std::string compress(std::string_view content);

 private:
  CompressionContext context_;
};

// Keeps its working memory between calls.
class Decompressor {
 public:
  Decompressor();

  // The content of one whole zstd frame, at most `limit` bytes of it; nothing where the frame is
  // not valid or holds more. Memory grows with what is really decoded, never with what the frame
  // claims. The answer is valid until the next call.
  std::optional<std::string_view> decompress(std::string_view bytes, std::size_t limit);

 private:
  DecompressionContext context_;
  std::string content_;
};

// Entropy coding of runs of byte symbols: there are so many kinds (FORMAT.md, section 8.5), each
// with a table that is known beforehand, which is taken where no other is much better.
inline constexpr std::size_t symbol_kinds = 3;

// Keeps its working memory between calls and nothing else.
class SymbolCompressor {
 public:
  SymbolCompressor();

  // Appends a run to `to`: of one symbol or more never more than they are themselves, and a number.
  void append(std::size_t kind, std::span<const unsigned char> symbols, std::string& to);

 private:
  std::string_view packed(std::size_t kind, std::span<const unsigned char> run);

  std::array<CompressionContext, symbol_kinds + 1> contexts_;  // the last without a table
  std::array<std::string, 2> packed_;
};

class SymbolDecompressor {
 public:
  SymbolDecompressor();

  // Takes a run of exactly as many symbols off the front of `from`; false where it does not begin
  // with such a run.
  bool take(std::size_t kind, ByteTaker& from, std::span<unsigned char> symbols);

 private:
  struct FreeDictionary {
    void operator()(ZSTD_DDict_s* dictionary) const;
  };
  DecompressionContext context_;
  std::array<std::unique_ptr<ZSTD_DDict_s, FreeDictionary>, symbol_kinds> dictionaries_;
};

}  // namespace ribbon
