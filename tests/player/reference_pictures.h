// Pictures that are kept, so that a change of what is shown is noticed and looked at.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "player/picture/picture.h"

namespace ribbon {

// How two pictures of the same size differ.
struct PictureDifference {
  double decibels = 0;  // peak signal-to-noise ratio; infinite where they are equal
  double far_off = 0;   // share of the pixels of which a channel differs by more than 8 levels
};

PictureDifference difference(const Picture& a, const Picture& b);

// Compilers and vector instructions round in different ways, which moves few pixels, but these as
// far as an edge is high: 45 dB at least, and one pixel in a thousand far off at most.
bool is_within_tolerance(const PictureDifference& difference);

class ReferencePictures {
 public:
  // The folder of the PNG files that are kept, and the one for what was found instead.
  ReferencePictures(std::filesystem::path kept, std::filesystem::path found);

  // Does `picture` look like NAME.png? If not, it is written to the second folder: as NAME.png
  // where there is none to compare it with, otherwise as NAME-got.png, beside NAME-difference.png,
  // which shows eight times what it is brighter or darker than grey. The answer names them.
  [[nodiscard]] testing::AssertionResult shows(const std::string& name,
                                               const Picture& picture) const;

 private:
  [[nodiscard]] std::filesystem::path write(const std::string& file, const Picture& picture) const;

  std::filesystem::path kept_;
  std::filesystem::path found_;
};

// Of an 8-bit PNG file without transparency; fails the running test where it is none.
Picture read_png(const std::filesystem::path& path);

}  // namespace ribbon
