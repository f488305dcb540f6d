// A page as part of a program.
#pragma once

#include <string_view>

// Defines `name`, a function that returns the page that the build has put into the program (its
// source alone is told which, by RIBBON_EMBEDDED_PAGE): the assembler copies the file.
#define RIBBON_EMBED_PAGE(name)                      \
  asm(".section .rodata\n" #name                     \
      "_begin:\n"                                    \
      ".incbin \"" RIBBON_EMBEDDED_PAGE "\"\n" #name \
      "_end:\n"                                      \
      ".byte 0\n.text\n");                           \
  extern "C" {                                       \
  extern const char name##_begin[];                  \
  extern const char name##_end[];                    \
  }                                                  \
  std::string_view name() {                          \
    return {name##_begin, name##_end};               \
  }
