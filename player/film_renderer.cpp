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

OutputPicture rendered(SequenceRenderer& renderer, const Annotations& annotations,
                       const Camera& camera, PictureSize size, PictureFormat format,
                       const PlayedFrame& frame) {
  OutputPicture output{frame.number, frame.index + 1};
  if (format == PictureFormat::exr) {
    output.image = renderer.light(camera, size);
    return output;
  }
  Picture picture = renderer.picture(camera, size);
  annotations.draw(frame.index, renderer.scene(), camera, picture);
  output.image = std::move(picture);
  return output;
}

FilmRenderer::FilmRenderer(RecordingReader& reader, const Options& options, std::vector<Shot> shots,
                           std::vector<Output>& outputs)
    : reader_(reader),
      options_(options),
      outputs_(outputs),
      cameras_(reader, std::move(shots)),
      renderer_(reader, options.render),
      next_(outputs.size()),
      progress_("picture", wanted(outputs), options.progress) {}

Result<void> FilmRenderer::prepare(const std::vector<int>& asked) {
  const Appearance& appearance = options_.appearance;
  renderer_.set_lowest(cameras_.lowest_m());
  if (auto colored = color_as_asked(appearance, reader_, asked, renderer_); !colored)
    return colored;
  annotations_.emplace(reader_, appearance.overlays, renderer_.legend());
  return {};
}

Result<void> FilmRenderer::render(const PlayedFrame& frame) {
  bool is_shown = false;
  for (std::size_t shot = 0; shot < outputs_.size(); ++shot) {
    if (!is_wanted(shot, frame)) continue;
    if (!std::exchange(is_shown, true))
      if (auto shown = renderer_.show(frame.index); !shown) return shown;
    const Output& output = outputs_[shot];
    const Camera camera = cameras_.camera(shot, {frame.index, frame.progress});
    auto taken = output.sink->put(
        rendered(renderer_, *annotations_, camera, options_.size, output.format, frame));
    if (!taken) return taken;
    progress_.update(++done_);
  }
  return {};
}

// What an output wants is a part of the film, in the same order.
bool FilmRenderer::is_wanted(std::size_t shot, const PlayedFrame& frame) {
  const std::vector<PlayedFrame>& frames = outputs_[shot].frames;
  if (next_[shot] == frames.size() || frames[next_[shot]] != frame) return false;
  ++next_[shot];
  return true;
}

}  // namespace ribbon
