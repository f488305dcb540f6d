#include "player/render/sequence_renderer.h"

#include "player/render/render.h"

namespace ribbon {

std::vector<Camera> frame_cameras(RecordingReader& reader, const std::vector<Shot>& shots) {
  std::vector<Framing> framings;
  framings.reserve(shots.size());
  for (const Shot& shot : shots) framings.emplace_back(shot.view, shot.size);
  const auto include = [&framings](const Eigen::Matrix3Xf& points) {
    for (Framing& framing : framings) framing.include(points);
  };
  if (reader.header().obstacle) include(reader.header().obstacle->vertices);
  Eigen::Matrix3Xf positions;
  for (int index = 0; index < reader.frame_count(); ++index) {
    if (reader.readable(index) && reader.read(index, positions)) include(positions);
  }
  std::vector<Camera> cameras;
  cameras.reserve(shots.size());
  for (const Framing& framing : framings) cameras.push_back(framing.camera());
  return cameras;
}

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
