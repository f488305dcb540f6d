// USD's text form as words, numbers and marks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "converter/read_back/written_bytes.h"

namespace ribbon {

// Reads forwards, a piece of the file at a time, from anywhere. Throws Spoiled where the text is
// not what is asked for.
class UsdTokens {
 public:
  explicit UsdTokens(const std::filesystem::path& path) : bytes_(path) { go_to(0); }

  [[nodiscard]] std::uint64_t place() const { return begin_ + at_; }
  void go_to(std::uint64_t place);

  // The next character that is no space; 0 at the end.
  char peek();
  // Is it this one? Takes it then.
  bool take_if(char mark);
  void take(char mark);
  // "name", "a:b.timeSamples", "<...>": up to a space or a mark.
  std::string word();
  // In quotation marks, which are taken off.
  std::string string();
  // The name of a file, between @ and @, or between @@@ and @@@ where it holds one itself.
  void skip_asset();
  double number();
  // Adds all numbers of a value: of one alone, of an array [a, b], and of tuples [(a, b), (c, d)].
  void value(std::vector<double>& numbers) { value(numbers, 0); }
  void skip_array();

 private:
  void value(std::vector<double>& numbers, int depth);
  char next();
  bool refill();

  WrittenBytes bytes_;
  std::string piece_;
  std::uint64_t begin_ = 0;  // of the piece in the file
  std::size_t at_ = 0;       // in the piece
};

}  // namespace ribbon
