#include "player/render/sequence_renderer.h"

#include "player/render/render.h"

namespace ribbon {

SequenceRenderer::SequenceRenderer(RecordingReader& reader, int samples)
    : reader_(reader), scene_(reader.header()), patterns_(samples) {}

Result<void> SequenceRenderer::show(int index) {
  if (auto read = reader_.read(index, positions_); !read) return read;
  scene_.set_ribbon(positions_);
  return {};
}

Picture SequenceRenderer::picture(const Camera& camera, PictureSize size) const {
  return encode_srgb(render(scene_, camera, size, patterns_));
}

}  // namespace ribbon
