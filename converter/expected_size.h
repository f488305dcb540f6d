// How large the files of a conversion will be, from a few frames that are really encoded.
#pragma once

#include <cstdint>

#include "converter/conversion.h"
#include "converter/conversion_job.h"
#include "result/result.h"

namespace ribbon {

struct ExpectedSize {
  double bytes = 0;
  double margin_bytes = 0;  // either way: as far as the frames that were tried differ
  double processor_s = 0;   // of all frames; 0: not known
};

// Encodes some of the job's frames as they would be written; those of one file into one in the
// temporary folder, which goes again. Fails where the conversion would.
Result<ExpectedSize> expected_size(const ConversionRequest& request, ConversionJob& job);

}  // namespace ribbon
