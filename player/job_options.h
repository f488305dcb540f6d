// Which options go with what is asked for.
#pragma once

#include <vector>

#include "commandline/arguments.h"
#include "result/result.h"

namespace ribbon {

// Fails at the first option that nothing of what is asked for looks at, as `--info --frames 5`.
// Pictures (--output) look at all of them but for those that need another option anyway.
Result<void> check_job_options(const std::vector<GivenArgument>& given);

}  // namespace ribbon
