#include "player/picture/caption.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <array>
#include <stdexcept>
#include <string>

#include "player/picture/caption_font.h"
#include "text/characters.h"

namespace ribbon {

namespace {

// The font is ours and in memory; only a lack of memory is left to go wrong.
void check(FT_Error error) {
  if (error != 0) throw std::runtime_error("FreeType reports error " + std::to_string(error));
}

void draw_glyph(const FT_GlyphSlotRec* glyph, int left, int baseline,
                const std::array<std::uint8_t, 3>& ink, Picture& picture) {
  const FT_Bitmap& bitmap = glyph->bitmap;
  for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
    const int y = baseline - glyph->bitmap_top + row;
    if (y < 0 || y >= picture.size.height) continue;
    for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
      const int x = left + glyph->bitmap_left + column;
      if (x < 0 || x >= picture.size.width) continue;
      blend(ink, bitmap.buffer[row * bitmap.pitch + column], picture.pixel(x, y));
    }
  }
}

}  // namespace

struct CaptionPainter::State {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  State() {
    check(FT_Init_FreeType(&library));
    const auto font = caption_font();
    check(FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(font.data()),
                             static_cast<FT_Long>(font.size()), 0, &face));
  }
  ~State() {
    FT_Done_Face(face);
    FT_Done_FreeType(library);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  // Calls glyph(slot, pen) for each character, drawn and `pen` pixels from the line's beginning;
  // returns where the line ends.
  template <class Function>
  int walk(std::string_view text, int height, const Function& glyph) {
    check(FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(height)));
    int pen = 0;
    while (!text.empty()) {
      check(FT_Load_Char(face, take_character(text), FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT));
      glyph(face->glyph, pen);
      pen += static_cast<int>(face->glyph->advance.x >> 6);
    }
    return pen;
  }
};

CaptionPainter::CaptionPainter() : state_(std::make_unique<State>()) {}
CaptionPainter::CaptionPainter(CaptionPainter&&) noexcept = default;
CaptionPainter& CaptionPainter::operator=(CaptionPainter&&) noexcept = default;
CaptionPainter::~CaptionPainter() = default;

int CaptionPainter::width(std::string_view text, int height) const {
  return state_->walk(text, height, [](FT_GlyphSlot, int) {});
}

std::string CaptionPainter::fitted(std::string_view text, int height, int room) const {
  if (width(text, height) <= room) return std::string(text);
  constexpr std::string_view ellipsis = "…";
  const int left = room - width(ellipsis, height);
  std::size_t kept = 0;
  for (std::string_view rest = text; !rest.empty();) {
    take_character(rest);
    const std::size_t with_this = text.size() - rest.size();
    if (width(text.substr(0, with_this), height) > left) break;
    kept = with_this;
  }
  return std::string(text.substr(0, kept)).append(ellipsis);
}

void CaptionPainter::draw(std::string_view text, int left, int baseline, int height,
                          const Color& ink, Picture& picture) const {
  const auto bytes = srgb_bytes(ink);
  state_->walk(text, height, [&](FT_GlyphSlot glyph, int pen) {
    draw_glyph(glyph, left + pen, baseline, bytes, picture);
  });
}

}  // namespace ribbon
