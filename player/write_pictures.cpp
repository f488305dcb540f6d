#include "player/write_pictures.h"

#include <chrono>
#include <utility>

#include "commandline/interrupt.h"
#include "commandline/progress.h"
#include "player/picture/png_encoder.h"
#include "text/number_text.h"

namespace ribbon {

Result<std::string> write_pictures(RecordingReader& reader, const std::vector<int>& frames,
                                   const FramePattern& pattern, const Options& options) {
  const auto cameras = frame_cameras(reader, {{three_quarter_view, options.size}});
  SequenceRenderer renderer(reader, options.samples);
  ProgressLine progress("picture", static_cast<int>(frames.size()), options.quiet);
  const Interrupt interrupt;
  const auto start = std::chrono::steady_clock::now();
  int done = 0;
  for (const int index : frames) {
    if (interrupt.requested())
      return failure("", filled_in("interrupted before frame {}", index + 1),
                     "run it again with --frames to go on");
    if (auto shown = renderer.show(index); !shown) return tl::unexpected(shown.error());
    const Picture picture = renderer.picture(cameras.front(), options.size);
    if (auto written = write_png(pattern.file(index + 1), picture); !written)
      return tl::unexpected(written.error());
    progress.update(++done);
  }
  progress.clear();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return filled_in("{} {}, {:.2f} s each, last: {}", done, done == 1 ? "picture" : "pictures",
                   elapsed.count() / done, pattern.file(frames.back() + 1).string());
}

LivePictures::LivePictures(RecordingReader& reader, const Options& options, FramePattern pattern)
    : reader_(reader),
      options_(options),
      pattern_(std::move(pattern)),
      renderer_(reader, options.samples) {}

Result<void> LivePictures::show(int index) {
  if (cameras_.empty()) cameras_ = frame_cameras(reader_, {{three_quarter_view, options_.size}});
  if (auto shown = renderer_.show(index); !shown) return shown;
  return write_png(pattern_.file(index + 1), renderer_.picture(cameras_.front(), options_.size));
}

}  // namespace ribbon
