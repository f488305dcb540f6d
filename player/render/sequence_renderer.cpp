#include "player/render/sequence_renderer.h"

#include <utility>

namespace ribbon {

SequenceRenderer::SequenceRenderer(RecordingReader& reader, RenderSettings settings)
    : reader_(reader), scene_(reader.header()), renderer_(std::move(settings)) {}

Result<void> SequenceRenderer::show(int index) {
  if (auto read = reader_.read(index, positions_); !read) return read;
  scene_.set_ribbon(positions_);
  return {};
}

Picture SequenceRenderer::picture(const Camera& camera, PictureSize size) {
  return encode_srgb(renderer_.render(scene_, camera, size).light);
}

}  // namespace ribbon
