#include "recorder/page/sketch_page.h"

#include "page/embedded_page.h"

namespace ribbon {

#ifdef RIBBON_EMBEDDED_PAGE
RIBBON_EMBED_PAGE(sketch_page)
#else
std::string_view sketch_page() {
  return {};
}
#endif

}  // namespace ribbon
