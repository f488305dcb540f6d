// How the input curve looks in pictures and previews.
#pragma once

#include "player/picture/color.h"

namespace ribbon::curve_style {

inline const Color ink = from_srgb(0xE8178A);
inline constexpr float pixels = 3.5F;  // wide, of a picture 720 pixels high
inline constexpr float hidden_opacity = 0.3F;
// So much nearer to the eye, in ribbon widths, is it taken to be: in the cloth it lies on it.
inline constexpr float forward = 0.1F;

}  // namespace ribbon::curve_style
