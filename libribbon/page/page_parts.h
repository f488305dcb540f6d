// A page with places for what is put into it, written as {{name}}.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ribbon {

// Either text as it is, or the name of a place.
struct PagePart {
  std::string_view text;
  bool is_place = false;
};

// In their order; they borrow from `page`. What is opened and not closed is text.
std::vector<PagePart> page_parts(std::string_view page);

}  // namespace ribbon
