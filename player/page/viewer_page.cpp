#include "player/page/viewer_page.h"

#ifdef RIBBON_VIEWER_PAGE

// The assembler copies the file into the program; the build says which one.
asm(".section .rodata\n"
    "ribbon_viewer_page_begin:\n"
    ".incbin \"" RIBBON_VIEWER_PAGE
    "\"\n"
    "ribbon_viewer_page_end:\n"
    ".byte 0\n"
    ".text\n");

extern "C" {
extern const char ribbon_viewer_page_begin[];
extern const char ribbon_viewer_page_end[];
}

namespace ribbon {

std::string_view viewer_page() {
  return {ribbon_viewer_page_begin, ribbon_viewer_page_end};
}

}  // namespace ribbon

#else

namespace ribbon {

std::string_view viewer_page() {
  return {};
}

}  // namespace ribbon

#endif
