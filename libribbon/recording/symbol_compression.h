// Entropy coding of short runs of byte symbols by zstd, each kind of run with a table of its own.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ribbon {

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
