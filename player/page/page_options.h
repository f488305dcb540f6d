// Which options go with a page that plays a recording.
#pragma once

#include <string>
#include <vector>

#include "commandline/arguments.h"
#include "result/result.h"

namespace ribbon {

// Is the output a page?
bool is_page(const std::string& output);

// Fails at the first option that a page cannot follow: frames, sizes and cameras are chosen by
// whoever looks at it.
Result<void> check_page_options(const std::vector<GivenArgument>& given);

}  // namespace ribbon
