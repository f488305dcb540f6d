// Words in pictures.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "player/picture/picture.h"

namespace ribbon {

class CaptionPainter {
 public:
  CaptionPainter();
  CaptionPainter(CaptionPainter&&) noexcept;
  CaptionPainter& operator=(CaptionPainter&&) noexcept;
  ~CaptionPainter();

  // How many pixels wide a line of UTF-8 text is when drawn `height` pixels high.
  [[nodiscard]] int width(std::string_view text, int height) const;

  // The text, or as much of it from its beginning as fits into `room` pixels with an ellipsis.
  [[nodiscard]] std::string fitted(std::string_view text, int height, int room) const;

  // Draws one line from `left` on, with its letters standing on row `baseline`; what falls outside
  // the picture is left out. Bytes that are not UTF-8 become U+FFFD.
  void draw(std::string_view text, int left, int baseline, int height, const Color& ink,
            Picture& picture) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon
