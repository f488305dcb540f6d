#include "page/page_parts.h"

namespace ribbon {

std::vector<PagePart> page_parts(std::string_view page) {
  std::vector<PagePart> parts;
  while (!page.empty()) {
    const std::size_t begin = page.find("{{");
    const std::size_t end = page.find("}}", begin);
    if (end == std::string_view::npos) break;
    parts.push_back({page.substr(0, begin), false});
    parts.push_back({page.substr(begin + 2, end - begin - 2), true});
    page.remove_prefix(end + 2);
  }
  parts.push_back({page, false});
  return parts;
}

}  // namespace ribbon
