// zstd, for everything in a recording that is not a plain number.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

struct FreeDictionary {
  void operator()(ZSTD_DDict_s* dictionary) const;
};

// Entropy coding of runs of byte symbols, of four kinds (FORMAT.md, section 8.5), with tables that
// are known for each kind where no other is much better. Keeps its working memory between calls and
// nothing else.
class SymbolCompressor {
 public:
  SymbolCompressor();

  // Appends a run to `to`: of one symbol or more never more than they are themselves, and a number.
  void append(std::size_t kind, std::span<const unsigned char> symbols, std::string& to);

 private:
  std::array<CompressionContext, 4> contexts_;  // of each kind
  CompressionContext with_own_table_;
  std::string packed_;
  std::string other_;
};

class SymbolDecompressor {
 public:
  SymbolDecompressor();

  // Takes a run of exactly as many symbols off the front of `from`; false where it does not begin
  // with such a run.
  bool take(std::size_t kind, std::string_view& from, std::span<unsigned char> symbols);

 private:
  DecompressionContext context_;
  std::array<std::unique_ptr<ZSTD_DDict_s, FreeDictionary>, 4> dictionaries_;  // of each kind
  std::string packed_;
};

}  // namespace ribbon
