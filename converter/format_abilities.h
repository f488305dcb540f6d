// What the formats can hold and say.
#pragma once

#include "converter/conversion.h"
#include "converter/output_format.h"
#include "result/result.h"

namespace ribbon {

// Fails where the request asks for what the format has no place for: it would be left out silently
// otherwise.
Result<void> check_abilities(const ConversionRequest& request, OutputFormat format);

}  // namespace ribbon
