// What the preview draws into.
#pragma once

#include <vector>

#include "player/picture/picture.h"
#include "player/preview/gl.h"
#include "result/result.h"

namespace ribbon {

// Colour and depth of a part of a picture.
class RenderTarget {
 public:
  // antialiased: edges are drawn with four samples a pixel. Keeps a reference to `gl`.
  RenderTarget(const Gl& gl, bool antialiased);

  // From now on this is drawn into. Its size is changed where it is another one; fails where there
  // is no memory for it.
  Result<void> prepare(PictureSize size);

  // Four bytes a pixel, red first, row by row from the bottom.
  void read(std::vector<std::uint8_t>& pixels) const;

 private:
  struct Buffers {
    GLuint frame = 0;
    GLuint color = 0;
    GLuint depth = 0;
  };
  Buffers make(GLsizei samples);
  void free(const Buffers& buffers) const;

  const Gl* gl_;
  bool antialiased_;
  PictureSize size_{0, 0};
  Buffers drawn_;
  Buffers resolved_;  // where samples become pixels; not there without antialiasing
};

}  // namespace ribbon
