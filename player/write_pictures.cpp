#include "player/write_pictures.h"

#include <chrono>
#include <utility>

#include "commandline/interrupt.h"
#include "commandline/progress.h"
#include "player/picture/png_encoder.h"
#include "player/shots.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr int any_number = 2;  // of frames: all but a single one need a place for it

}  // namespace

Result<std::string> write_pictures(RecordingReader& reader, const std::vector<int>& frames,
                                   const Options& options) {
  const auto patterns = patterns_of(options, static_cast<int>(frames.size()));
  if (!patterns) return tl::unexpected(patterns.error());
  const auto shots = shots_of(options);
  if (!shots) return tl::unexpected(shots.error());
  const CameraWork cameras(reader, *shots);
  SequenceRenderer renderer(reader, options.render);
  renderer.set_lowest(cameras.lowest_m());
  if (auto colored = color_as_asked(options.appearance, reader, frames, renderer); !colored)
    return tl::unexpected(colored.error());
  const Annotations annotations(reader, options.appearance.overlays, renderer.legend());
  const auto pictures = static_cast<int>(frames.size() * shots->size());
  ProgressLine progress("picture", pictures, options.quiet);
  const Interrupt interrupt;
  const auto start = std::chrono::steady_clock::now();
  int done = 0;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const int index = frames[f];
    if (interrupt.requested())
      return failure("", filled_in("interrupted before frame {}", index + 1),
                     "run it again with --frames to go on");
    if (auto shown = renderer.show(index); !shown) return tl::unexpected(shown.error());
    const Moment moment{index, static_cast<double>(f) / static_cast<double>(frames.size())};
    for (std::size_t shot = 0; shot < shots->size(); ++shot) {
      const Camera camera = cameras.camera(shot, moment);
      Picture picture = renderer.picture(camera, options.size);
      annotations.draw(index, renderer.scene(), camera, picture);
      if (auto written = write_png((*patterns)[shot].file(index + 1), picture); !written)
        return tl::unexpected(written.error());
      progress.update(++done);
    }
  }
  progress.clear();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return filled_in("{} {}, {:.2f} s each, last: {}", done, done == 1 ? "picture" : "pictures",
                   elapsed.count() / done, patterns->back().file(frames.back() + 1).string());
}

LivePictures::LivePictures(RecordingReader& reader, const Options& options)
    : reader_(reader), options_(options), renderer_(reader, options.render) {}

Result<void> LivePictures::begin() {
  auto patterns = patterns_of(options_, any_number);
  if (!patterns) return tl::unexpected(patterns.error());
  patterns_ = std::move(*patterns);
  auto shots = shots_of(options_);
  if (!shots) return tl::unexpected(shots.error());
  shots_ = std::move(*shots);
  const Appearance& appearance = options_.appearance;
  if (auto colored = color_as_asked(appearance, reader_, {}, renderer_); !colored) return colored;
  annotations_.emplace(reader_, appearance.overlays, renderer_.legend());
  return {};
}

Result<void> LivePictures::show(int index) {
  if (!cameras_) {
    cameras_.emplace(reader_, shots_);
    renderer_.set_lowest(cameras_->lowest_m());
  }
  if (auto shown = renderer_.show(index); !shown) return shown;
  for (std::size_t shot = 0; shot < shots_.size(); ++shot) {
    const Camera camera = cameras_->camera(shot, {index, 0});
    Picture picture = renderer_.picture(camera, options_.size);
    annotations_->draw(index, renderer_.scene(), camera, picture);
    if (auto written = write_png(patterns_[shot].file(index + 1), picture); !written)
      return written;
  }
  return {};
}

}  // namespace ribbon
