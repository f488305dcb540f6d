#include "player/overlay/overlays.h"

#include <array>
#include <string_view>

namespace ribbon {

namespace {

struct OverlayWord {
  std::string_view word;
  bool Overlays::*is_asked;
};
constexpr std::array<OverlayWord, 6> overlay_words = {
    {{"wireframe", &Overlays::wireframe},
     {"obstacle-wireframe", &Overlays::obstacle_wireframe},
     {"curve", &Overlays::curve},
     {"frame", &Overlays::frame},
     {"time", &Overlays::time},
     {"numbers", &Overlays::numbers}}};

std::string all_words() {
  std::string text;
  for (const OverlayWord& known : overlay_words)
    text += (text.empty() ? "" : ", ") + std::string(known.word);
  return text;
}

}  // namespace

Result<Overlays> parse_overlays(const std::string& text) {
  Overlays overlays;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    bool known = false;
    for (const OverlayWord& overlay : overlay_words)
      if (overlay.word == word) known = overlays.*overlay.is_asked = true;
    if (!known)
      return failure("--overlay", "does not know '" + word + "'",
                     "write some of " + all_words() + ", with commas between them");
    begin = end + 1;
  }
  return overlays;
}

}  // namespace ribbon
