// The files of a sequence, by name.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "commandline/frame_pattern.h"
#include "converter/conversion.h"
#include "result/result.h"

namespace ribbon {

// Slots count the asked frames from 0.
class SequenceNames {
 public:
  // `frames`: indices from 0. Fails when request.output has no good place for the number.
  static Result<SequenceNames> of(const ConversionRequest& request, const std::vector<int>& frames);

  // In its file's name: as recorded, or counted from request.start_frame.
  [[nodiscard]] int number(std::size_t slot) const { return numbers_[slot]; }
  [[nodiscard]] std::filesystem::path frame(std::size_t slot) const {
    return pattern_.file(numbers_[slot]);
  }
  [[nodiscard]] std::vector<std::filesystem::path> frames() const;

  // The name of OBJ's material library.
  [[nodiscard]] std::string library() const;
  // All that get frames, since {frame} may stand in a folder's name.
  [[nodiscard]] std::set<std::filesystem::path> folders() const;

  // What tells, while frames are missing, which of them are complete.
  [[nodiscard]] std::filesystem::path log() const;

 private:
  SequenceNames(std::string output, FramePattern pattern, std::vector<int> numbers);

  std::string output_;
  FramePattern pattern_;
  std::vector<int> numbers_;
};

}  // namespace ribbon
