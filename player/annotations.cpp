#include "player/annotations.h"

#include <algorithm>
#include <utility>

#include "player/overlay/frame_caption.h"
#include "player/picture/curve_style.h"
#include "player/view/scene_model.h"

namespace ribbon {

namespace {

const Color dark_line = from_srgb(0x101418);
const Color light_line = from_srgb(0xFFFFFF);

// As thick in large pictures as in small ones.
float line_width(PictureSize size) {
  return std::max(0.8F, static_cast<float>(size.height) / 720);
}

// As far as they look the same, so much nearer to the eye: a line in the cloth lies on it.
Eigen::Matrix3Xf moved_forward(Eigen::Matrix3Xf points, const Camera& camera, float way_m) {
  for (auto point : points.colwise()) point += way_m * (camera.eye - point).normalized();
  return points;
}

}  // namespace

Result<void> color_as_asked(const Appearance& appearance, RecordingReader& reader,
                            const std::vector<int>& frames, SequenceRenderer& renderer) {
  if (!appearance.color_by) return {};
  auto colors = ValueColors::create(reader, *appearance.color_by, appearance.color_range, frames);
  if (!colors) return tl::unexpected(colors.error());
  renderer.color_by(std::move(*colors));
  return {};
}

Annotations::Annotations(const RecordingReader& reader, const Overlays& overlays,
                         std::optional<Legend> legend)
    : reader_(reader), overlays_(overlays), legend_(std::move(legend)) {
  const RecordingHeader model = model_of(reader.header());
  if (overlays_.obstacle_wireframe && model.obstacle) obstacle_lines_ = mesh_lines(*model.obstacle);
  if (overlays_.curve) curve_ = model.input_curve;
  forward_m_ = curve_style::forward * static_cast<float>(model.ribbon_width_m);
}

void Annotations::draw_lines_of(const RenderScene& scene, const Camera& camera,
                                Picture& picture) const {
  const float width = line_width(picture.size);
  if (!obstacle_lines_.lines.empty())
    draw_lines(obstacle_lines_, {dark_line, width, 0.4F}, scene, camera, picture);
  if (overlays_.wireframe)
    draw_lines(ribbon_lines(reader_.header().grid, scene.ribbon().vertices),
               {legend_ ? dark_line : light_line, width, 0.6F}, scene, camera, picture);
  if (overlays_.curve) draw_curve(scene, camera, width, picture);
}

void Annotations::draw_curve(const RenderScene& scene, const Camera& camera, float width,
                             Picture& picture) const {
  draw_lines(polyline(moved_forward(curve_, camera, forward_m_)),
             {curve_style::ink, curve_style::pixels * width, 1, curve_style::hidden_opacity}, scene,
             camera, picture);
}

FrameNumbers Annotations::numbers(int index, double after) const {
  const FrameNumbers before = reader_.numbers(index).value_or(FrameNumbers{});
  if (after == 0) return before;
  const FrameNumbers next = reader_.numbers(index + 1).value_or(before);
  FrameNumbers nearer = after < 0.5 ? before : next;
  nearer.time_s = before.time_s + after * (next.time_s - before.time_s);
  return nearer;
}

void Annotations::draw_words(int index, double after, Picture& picture) const {
  if (overlays_.has_caption()) {
    const FrameNumbers shown = numbers(index, after);
    const std::string stage(stage_name(reader_.header(), shown));
    draw_caption(frame_caption(overlays_, index + 1 + after, shown, stage), painter_, picture);
  }
  if (legend_) draw_corner_legend(*legend_, painter_, picture);
}

}  // namespace ribbon
