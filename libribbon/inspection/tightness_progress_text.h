// How far a ribbon gets that is being fastened, in words.
#pragma once

#include <string>

namespace ribbon {

// "progress 95.0 %", of TightnessNumbers::progress. What hands hardly pull and something else moves
// goes any multiple of their way: beyond ten times it is "progress over 1000 %", or "below -1000
// %".
std::string tightness_progress_text(float progress);

}  // namespace ribbon
