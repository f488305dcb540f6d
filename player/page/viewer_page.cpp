#include "player/page/viewer_page.h"

#include "page/embedded_page.h"

namespace ribbon {

#ifdef RIBBON_EMBEDDED_PAGE
RIBBON_EMBED_PAGE(viewer_page)
#else
std::string_view viewer_page() {
  return {};
}
#endif

}  // namespace ribbon
