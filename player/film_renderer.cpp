#include "player/film_renderer.h"

#include <utility>

namespace ribbon {

namespace {

int wanted(const std::vector<Output>& outputs) {
  std::size_t pictures = 0;
  for (const Output& output : outputs) pictures += output.frames.size();
  return static_cast<int>(pictures);
}

}  // namespace

Result<OutputPicture> rendered(FramePainter& painter, const Camera& camera, PictureSize size,
                               PictureFormat format, const PlayedFrame& frame) {
  OutputPicture output{frame.number, frame.frame()};
  if (format == PictureFormat::exr) {
    auto light = painter.light(camera, size);
    if (!light) return tl::unexpected(light.error());
    output.image = *std::move(light);
    return output;
  }
  auto picture = painter.picture(camera, size);
  if (!picture) return tl::unexpected(picture.error());
  painter.annotate(camera, *picture);
  output.image = *std::move(picture);
  return output;
}

FilmRenderer::FilmRenderer(RecordingReader& reader, const Options& options, std::vector<Shot> shots,
                           std::vector<Output>& outputs)
    : reader_(reader),
      options_(options),
      outputs_(outputs),
      cameras_(reader, std::move(shots)),
      next_(outputs.size()),
      progress_("picture", wanted(outputs), options.progress),
      check_(reader) {}

Result<void> FilmRenderer::prepare(const std::vector<int>& asked) {
  auto painter = FramePainter::create(reader_, options_, asked);
  if (!painter) return tl::unexpected(painter.error());
  painter_.emplace(*std::move(painter));
  painter_->set_lowest(cameras_.lowest_m());
  return {};
}

Result<void> FilmRenderer::render(const PlayedFrame& frame) {
  bool is_shown = false;
  for (std::size_t shot = 0; shot < outputs_.size(); ++shot) {
    if (!is_wanted(shot, frame)) continue;
    if (!std::exchange(is_shown, true))
      if (auto shown = show(frame); !shown) return shown;
    const Output& output = outputs_[shot];
    const Camera camera = cameras_.camera(shot, {frame.index, frame.progress, frame.after});
    auto picture = rendered(*painter_, camera, options_.size, output.format, frame);
    if (!picture) return tl::unexpected(picture.error());
    if (auto taken = output.sink->put(*std::move(picture)); !taken) return taken;
    progress_.update(++done_);
  }
  return {};
}

Result<void> FilmRenderer::show(const PlayedFrame& frame) {
  if (auto shown = painter_->show(frame.index, frame.after); !shown) return shown;
  if (!frame.is_interpolated()) return {};
  return check_.add(frame, interpolated_);
}

// What an output wants is a part of the film, in the same order.
bool FilmRenderer::is_wanted(std::size_t shot, const PlayedFrame& frame) {
  const std::vector<PlayedFrame>& frames = outputs_[shot].frames;
  if (next_[shot] == frames.size() || frames[next_[shot]] != frame) return false;
  ++next_[shot];
  return true;
}

}  // namespace ribbon
