// Whether the files that a conversion has written hold what was recorded.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converter/comparison.h"
#include "converter/conversion.h"
#include "result/result.h"

namespace ribbon {

struct VerificationReport {
  std::string extension;  // of the files
  std::string reader;     // who has read them
  Deviations deviations;
  std::vector<Damage> damage = {};  // of the recording
};

// Fails where the format holds no positions that could be compared.
Result<void> check_verifiable(const ConversionRequest& request);

// Reads all files back that `request` asks for, and compares them with the recording as it is now,
// frame by frame; what cannot be read is a difference. tolerance_m: ComparisonSettings. Fails where
// the conversion would, but for what exists, or when interrupted.
Result<VerificationReport> verify_output(const ConversionRequest& request,
                                         std::optional<double> tolerance_m);

// In words, for the user.
std::string verification_text(const VerificationReport& report);

}  // namespace ribbon
