// Places of a ribbon as users name them.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "recording/records/recording.h"
#include "result/result.h"

namespace ribbon {

// Shares of the ribbon's length, 0 to 1, of two texts: each the name of one of its marks or a
// number. Fails with what may be written where one is neither.
Result<std::array<double, 2>> shares_of(const std::vector<RecordedMark>& marks,
                                        const std::pair<std::string, std::string>& places);

}  // namespace ribbon
