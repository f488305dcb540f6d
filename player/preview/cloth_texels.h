// The cloth's pattern as an image that repeats along the ribbon.
#pragma once

#include <cstdint>
#include <vector>

namespace ribbon {

inline constexpr int texels_along = 128;
inline constexpr int texels_across = 256;
// After this part of the ribbon's width the pattern begins anew.
inline constexpr float pattern_period = 0.5F;

// Front, then back; of each row by row from one selvage to the other, four bytes a texel: the
// square roots of red, green and blue, and 255.
std::vector<std::uint8_t> cloth_texels();

}  // namespace ribbon
