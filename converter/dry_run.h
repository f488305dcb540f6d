// What a conversion would do.
#pragma once

#include <filesystem>
#include <string>

#include "converter/conversion.h"
#include "result/result.h"

namespace ribbon {

struct ConversionPlan {
  std::filesystem::path first_file;
  std::filesystem::path last_file;
  int files = 0;            // with those that lie beside the frames
  int existing = 0;         // of them, but for material libraries
  double bytes = 0;         // about
  double margin_bytes = 0;  // by so much they may differ
  double processor_s =
      0;  // about; 0: not known; all cores share it, and what the disk takes comes on top
};

// Writes nothing there. Reads and encodes a few frames, and takes the others to be like them. Fails
// where the conversion would, but for what exists already.
Result<ConversionPlan> plan_conversion(const ConversionRequest& request);

// In words, for the user.
std::string plan_text(const ConversionPlan& plan);

}  // namespace ribbon
