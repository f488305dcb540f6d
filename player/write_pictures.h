// Frames of a recording become pictures, and these files, a video or a stream.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "commandline/interrupt.h"
#include "playback/recording_reader.h"
#include "player/frame_painter.h"
#include "player/options.h"
#include "player/output/open_output.h"
#include "player/view/camera_work.h"
#include "result/result.h"

namespace ribbon {

// Renders `frames` (indices from 0; lost: those of the recording, ascending, that cannot be read)
// in the order of options.order. Each is encoded and written while the next one is rendered.
// Returns one line about it. Fails when something cannot be written or the user interrupts; files
// that are there are complete.
Result<std::string> write_pictures(RecordingReader& reader, const std::vector<int>& frames,
                                   const std::vector<int>& lost, const Options& options);

// Renders frames as they come. Cameras stand where the frames of the first look put them; one that
// follows the knot waits until it is known where that goes, so that its pictures are those of a
// later run.
class LivePictures {
 public:
  // Keeps references to `reader` and `options`.
  LivePictures(RecordingReader& reader, const Options& options);

  // Comes before all else; keeps a reference to `interrupt`. Fails when names, cameras or colours
  // make no sense, or a preview cannot be drawn.
  Result<void> begin(const Interrupt& interrupt);
  // Takes frame `index`, and renders what no longer has to wait.
  Result<void> show(int index);
  // Takes that the next frame is lost: in a stream the frame before is held, at the start the first
  // one after, as held_over() does it.
  Result<void> pass_lost();
  // After the last one: renders the rest, unless interrupted.
  Result<void> finish(const Interrupt& interrupt);

 private:
  Result<void> render_settled();
  Result<void> render(int index);

  RecordingReader& reader_;
  const Options& options_;
  std::vector<Shot> shots_;
  std::vector<Output> outputs_;          // of each shot
  std::optional<FramePainter> painter_;  // from begin() on
  std::optional<CameraWork> cameras_;    // once there is a frame
  std::deque<int> waiting_;              // frames that came and are not rendered
  std::optional<int> last_;              // that came
  std::size_t lost_before_ = 0;          // the first that came
};

}  // namespace ribbon
