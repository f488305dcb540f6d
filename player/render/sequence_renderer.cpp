#include "player/render/sequence_renderer.h"

#include <utility>

namespace ribbon {

SequenceRenderer::SequenceRenderer(RecordingReader& reader, RenderSettings settings)
    : reader_(reader), scene_(reader.header()), renderer_(std::move(settings)) {
  scene_.set_cloth(renderer_.settings().cloth);
}

void SequenceRenderer::set_lowest(float height_m) {
  if (renderer_.settings().ground) scene_.set_ground(height_m);
}

Result<void> SequenceRenderer::show(int index) {
  if (auto read = reader_.read(index, positions_); !read) return read;
  scene_.set_ribbon(positions_);
  if (colors_) scene_.color_ribbon(colors_->places(index, positions_), colors_->map());
  return {};
}

Picture SequenceRenderer::picture(const Camera& camera, PictureSize size) {
  return encode_srgb(renderer_.render(scene_, camera, size).light);
}

std::optional<Legend> SequenceRenderer::legend() const {
  if (!colors_) return std::nullopt;
  return colors_->legend();
}

}  // namespace ribbon
