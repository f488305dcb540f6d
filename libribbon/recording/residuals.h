// Residuals as bytes: small numbers near zero, sorted by how large they probably are.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "recording/activity.h"
#include "recording/prediction.h"

namespace ribbon {

// Parts for the compressor, to be followed by nothing else.
std::vector<std::string> pack_residuals(const PaddedGrid& grid, const Activity& activity,
                                        const Residuals& residuals);

// The inverse, from the parts one after the other. False where `bytes` does not hold exactly the
// residuals of a whole frame.
bool unpack_residuals(const PaddedGrid& grid, const Activity& activity, std::string_view bytes,
                      Residuals& residuals);

// More bytes than the parts of a valid frame ever have together.
std::size_t packed_residuals_limit(const PaddedGrid& grid);

}  // namespace ribbon
