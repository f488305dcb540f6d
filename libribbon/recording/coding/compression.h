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

// Entropy coding of short runs of byte symbols, each kind of run with a table of its own.
// Keeps its working memory between calls and nothing else.
class SymbolCompressor {
 public:
  // tables: a zstd dictionary for each kind of run; kinds beyond have none.
  explicit SymbolCompressor(std::span<const std::string> tables);
  SymbolCompressor(SymbolCompressor&&) noexcept;
  SymbolCompressor& operator=(SymbolCompressor&&) noexcept;
  ~SymbolCompressor();

  // Appends symbols of a kind to `bytes`: never more than they are themselves.
  void append(std::size_t kind, std::string_view symbols, std::string& bytes);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

class SymbolDecompressor {
 public:
  // The tables of the compressor. Those that are no zstd dictionaries make runs unreadable.
  explicit SymbolDecompressor(std::span<const std::string> tables);
  SymbolDecompressor(SymbolDecompressor&&) noexcept;
  SymbolDecompressor& operator=(SymbolDecompressor&&) noexcept;
  ~SymbolDecompressor();

  // Takes exactly `count` symbols of a kind off the front of `bytes`; false where they do not begin
  // with such a run.
  bool take(std::size_t kind, std::string_view& bytes, std::size_t count, unsigned char* symbols);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon
