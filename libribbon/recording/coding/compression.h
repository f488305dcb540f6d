// zstd, for everything in a recording that is not a plain number.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ribbon {

// Keeps its working memory between calls. Equal input gives equal bytes.
class Compressor {
 public:
  Compressor();
  Compressor(Compressor&&) noexcept;
  Compressor& operator=(Compressor&&) noexcept;
  ~Compressor();

  // One zstd frame.
  std::string compress(std::string_view content);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Keeps its working memory between calls.
class Decompressor {
 public:
  Decompressor();
  Decompressor(Decompressor&&) noexcept;
  Decompressor& operator=(Decompressor&&) noexcept;
  ~Decompressor();

  // The content of one whole zstd frame, at most `limit` bytes of it; nothing where the frame is
  // not valid or holds more. Memory grows with what is really decoded, never with what the frame
  // claims. The answer is valid until the next call.
  std::optional<std::string_view> decompress(std::string_view bytes, std::size_t limit);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Entropy coding of runs of byte symbols. Keeps its working memory between calls and nothing else.
class SymbolCompressor {
 public:
  SymbolCompressor();
  SymbolCompressor(SymbolCompressor&&) noexcept;
  SymbolCompressor& operator=(SymbolCompressor&&) noexcept;
  ~SymbolCompressor();

  // Appends a run to `to`: of one symbol or more never more than they are themselves, and a number.
  void append(std::span<const unsigned char> symbols, std::string& to);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

class SymbolDecompressor {
 public:
  SymbolDecompressor();
  SymbolDecompressor(SymbolDecompressor&&) noexcept;
  SymbolDecompressor& operator=(SymbolDecompressor&&) noexcept;
  ~SymbolDecompressor();

  // Takes a run of exactly as many symbols off the front of `from`; false where it does not begin
  // with such a run.
  bool take(std::string_view& from, std::span<unsigned char> symbols);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon
