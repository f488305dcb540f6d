// File names with a place for the frame number: "out/knot.{frame:04}.obj".
#pragma once

#include <filesystem>
#include <string>

#include "result/result.h"

namespace ribbon {

class FramePattern {
 public:
  // "{frame}" or "{frame:04}" exactly once (a width of 1 to 9 digits, zero-padded). Fails when it
  // is missing or malformed.
  static Result<FramePattern> parse(const std::string& text);

  // Likewise for so many frames: a single one may also be named without a place for its number.
  static Result<FramePattern> parse(const std::string& text, int frame_count);

  // A file beside those of the frames, with `word` in the place of the number (or behind the name
  // where there is no place).
  [[nodiscard]] std::filesystem::path file(const std::string& word) const;

  // The file of frame `number`, at least 0.
  [[nodiscard]] std::filesystem::path file(int number) const;
  // Its number as it stands in the name: "0007"; nothing where there is no place.
  [[nodiscard]] std::string digits_of(int number) const;

 private:
  std::string before_;
  std::string after_;
  int digits_ = 4;  // at least; 0: none at all
};

}  // namespace ribbon
