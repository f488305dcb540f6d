#include "player/picture/caption_font.h"

// The assembler copies the file into the program; the build says which one.
asm(".section .rodata\n"
    ".balign 16\n"
    "ribbon_caption_font_begin:\n"
    ".incbin \"" RIBBON_CAPTION_FONT
    "\"\n"
    "ribbon_caption_font_end:\n"
    ".byte 0\n"
    ".text\n");

extern "C" {
extern const std::byte ribbon_caption_font_begin[];
extern const std::byte ribbon_caption_font_end[];
}

namespace ribbon {

std::span<const std::byte> caption_font() {
  return {ribbon_caption_font_begin, ribbon_caption_font_end};
}

}  // namespace ribbon
