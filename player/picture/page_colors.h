// The colours of everything that is written in or beside pictures.
#pragma once

#include "player/picture/color.h"

namespace ribbon {

inline const Color page_paper = from_srgb(0xFFFFFF);
inline const Color page_ink = from_srgb(0x222222);
inline const Color page_pale_ink = from_srgb(0x666666);

}  // namespace ribbon
