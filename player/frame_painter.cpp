#include "player/frame_painter.h"

namespace ribbon {

namespace {

Result<void> check_curve(const Overlays& overlays, const RecordingReader& reader) {
  if (!overlays.curve || reader.header().input_curve.cols() > 0) return {};
  return failure("--overlay curve", "the recording does not tell the curve that was drawn",
                 "record it again, or leave this overlay out");
}

}  // namespace

Result<FramePainter> FramePainter::create(RecordingReader& reader, const Options& options,
                                          const std::vector<int>& frames) {
  const Appearance& appearance = options.appearance;
  if (auto checked = check_curve(appearance.overlays, reader); !checked)
    return tl::unexpected(checked.error());
  if (options.preview) {
    auto preview = PreviewRenderer::create(reader, *options.preview);
    if (!preview) return tl::unexpected(preview.error());
    return FramePainter(*std::move(preview),
                        Annotations(reader, appearance.overlays, std::nullopt));
  }
  SequenceRenderer renderer(reader, options.render);
  if (auto colored = color_as_asked(appearance, reader, frames, renderer); !colored)
    return tl::unexpected(colored.error());
  Annotations annotations(reader, appearance.overlays, renderer.legend());
  return FramePainter(std::move(renderer), std::move(annotations));
}

void FramePainter::set_lowest(float lowest_m) {
  if (auto* ray_tracer = std::get_if<SequenceRenderer>(&renderer_))
    ray_tracer->set_lowest(lowest_m);
}

Result<void> FramePainter::show(int index, double after) {
  const Shown asked{index, after};
  if (shown_ == asked) return {};  // a frame that stands
  shown_.reset();
  auto loaded = std::visit([=](auto& renderer) { return renderer.show(index, after); }, renderer_);
  if (loaded) shown_ = asked;
  return loaded;
}

Result<Picture> FramePainter::picture(const Camera& camera, PictureSize size) {
  return std::visit(
      [&](auto& renderer) -> Result<Picture> { return renderer.picture(camera, size); }, renderer_);
}

Result<LightPicture> FramePainter::light(const Camera& camera, PictureSize size) {
  if (auto* ray_tracer = std::get_if<SequenceRenderer>(&renderer_))
    return ray_tracer->light(camera, size);
  return failure("--preview", "knows no linear light, which .exr files hold",
                 "write .png files, or leave --preview out");
}

void FramePainter::annotate(const Camera& camera, Picture& picture) const {
  if (const auto* ray_tracer = std::get_if<SequenceRenderer>(&renderer_))
    annotations_.draw_lines_of(ray_tracer->scene(), camera, picture);
  annotations_.draw_words(shown_->index, shown_->after, picture);
}

NoiseReached FramePainter::noise() const {
  const auto* ray_tracer = std::get_if<SequenceRenderer>(&renderer_);
  return ray_tracer == nullptr ? NoiseReached{} : ray_tracer->noise();
}

std::optional<Legend> FramePainter::legend() const {
  const auto* ray_tracer = std::get_if<SequenceRenderer>(&renderer_);
  return ray_tracer == nullptr ? std::nullopt : ray_tracer->legend();
}

}  // namespace ribbon
