// The font of the captions, part of the program.
#pragma once

#include <cstddef>
#include <span>

namespace ribbon {

// DejaVu Sans as a TrueType file.
std::span<const std::byte> caption_font();

}  // namespace ribbon
