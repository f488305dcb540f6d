// Light as it adds up, and light as a file stores it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

namespace ribbon {

// Linear light, red, green, blue (sRGB primaries); 1 is white on the screen.
using Color = Eigen::Array3f;

// The sRGB transfer function, rounded to 8 bits: 0.5 linear is 188. Clamps to what can be shown.
std::uint8_t srgb_byte(float linear);
std::array<std::uint8_t, 3> srgb_bytes(const Color& color);
// Of `count` colours, three bytes each.
void srgb_bytes(const Color* colors, std::size_t count, std::uint8_t* rgb);

// Linear light of a colour that was picked on a screen, as in 0xRRGGBB.
Color from_srgb(std::uint32_t rrggbb);

}  // namespace ribbon
