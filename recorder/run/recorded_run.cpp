#include "recorder/run/recorded_run.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "recorder/run/start.h"
#include "recording/codec/position_encoder.h"
#include "ribbon_mesh/marks.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;

// From a checkpoint, or why not.
Result<SimulatedFrames> from_checkpoint(const RecordedRun& run, std::uint32_t frame) {
  const auto checkpoint = run.reader.read_checkpoint(frame);
  if (!checkpoint) return tl::unexpected(checkpoint.error());
  auto fastening = FasteningProcessor::restore(run.scene, run.rest_size(),
                                               run.reader.header().obstacle, checkpoint->state);
  if (!fastening) return tl::unexpected(fastening.error());
  return SimulatedFrames(run.scene, *std::move(fastening), static_cast<int>(frame));
}

Result<SimulatedFrames> from_drawing(const RecordedRun& run) {
  const RecordingHeader& header = run.reader.header();
  if (header.origin)
    return failure(run.file.string(),
                   "there is no usable checkpoint of what was recorded since it branched off",
                   "branch off from '" + header.origin->scene_name + "' once more");
  auto start = find_start(run.scene, header.obstacle);
  if (!start) {
    start.error().problem = "there is no usable checkpoint, and the start cannot be made again: " +
                            start.error().place + ": " + start.error().problem;
    start.error().place = run.file.string();
    return tl::unexpected(start.error());
  }
  if (!(start->ribbon.size() == run.rest_size()))
    return failure(run.file.string(),
                   "there is no usable checkpoint, and the drawing is not the one it was recorded "
                   "from",
                   "record the scene anew");
  return SimulatedFrames(run.scene, std::move(start->fastening), -1);
}

// From the last checkpoint at or before the frame that can be used.
Result<SimulatedFrames> nearest_before(int index, const RecordedRun& run) {
  std::vector<std::uint32_t> checkpoints = run.reader.checkpoints();
  std::sort(checkpoints.rbegin(), checkpoints.rend());
  for (const std::uint32_t frame : checkpoints) {
    if (static_cast<int>(frame) > index) continue;
    auto frames = from_checkpoint(run, frame);
    if (frames) return frames;
  }
  return from_drawing(run);
}

// Compares frames with recorded ones, as they were decoded.
class Comparison {
 public:
  explicit Comparison(RecordedRun& run)
      : file_(run.file),
        reader_(run.reader),
        encoder_(codec_parameters(reader_.header()), reader_.header().max_position_error_m) {}

  [[nodiscard]] Result<void> numbers_agree(const SimulatedFrame& frame) const {
    const auto recorded = reader_.numbers(frame.index);
    if (!recorded) return {};
    FrameNumbers simulated = frame.numbers;
    // Once the name of the last stage was kept when all were over.
    if (simulated.stage == 0 && recorded->stage == reader_.header().stages.size())
      simulated.stage = recorded->stage;
    return *recorded == simulated ? Result<void>() : otherwise(frame.index);
  }

  Result<void> positions_agree(int index, const Eigen::Matrix3Xd& positions) {
    if (!reader_.readable(index) || !reader_.read(index, recorded_)) return {};
    const auto rounded = encoder_.rounded(positions);
    if (!rounded) return otherwise(index);
    rounded->positions(simulated_);
    return simulated_ == recorded_ ? Result<void>() : otherwise(index);
  }

 private:
  [[nodiscard]] Result<void> otherwise(int index) const {
    const std::string& writer = reader_.header().writer;
    if (writer.starts_with("ribbon-convert "))
      return failure(file_.string(),
                     "it was converted from another recording, with frames left out or rounded "
                     "again",
                     "go on with that one");
    return failure(filled_in("{}: frame {}", file_.string(), index + 1),
                   "simulated again, it comes out otherwise than recorded",
                   filled_in("go on with the program that recorded it, {}, on the same kind of "
                             "processor",
                             writer));
  }

  const fs::path& file_;
  RecordingReader& reader_;
  PositionEncoder encoder_;
  Eigen::Matrix3Xf recorded_;
  Eigen::Matrix3Xf simulated_;
};

// A run goes on by both; they differ only where somebody has changed one of them.
Result<void> check_agreement(const fs::path& file, const RecordingHeader& header,
                             const Scene& scene) {
  const RibbonGrid drawn{scene.ribbon.along, scene.ribbon.across};
  if (header.grid == drawn && header.stages.size() == scene.stages.size()) return {};
  return failure(file.string(),
                 filled_in("its header tells of {} x {} particles and {} stages, its scene of {} x "
                           "{} and {}",
                           header.grid.along, header.grid.across, header.stages.size(), drawn.along,
                           drawn.across, scene.stages.size()),
                 "record the scene anew");
}

}  // namespace

Result<RecordedRun> RecordedRun::open(const fs::path& file, std::optional<int> before_frame) {
  auto reader = RecordingReader::open(file);
  if (!reader) return tl::unexpected(reader.error());
  std::vector<std::string> settings;
  for (const Session& session : reader->sessions()) {
    // The scene's text has them already, and what a drawing told in their place.
    if (session.note.reason == SessionReason::begun) continue;
    const bool is_later = before_frame && static_cast<int>(session.first_frame) >= *before_frame;
    std::istringstream lines(session.note.changed_settings);
    for (std::string line; std::getline(lines, line);)
      if (!line.empty() && !(is_later && line == drawn_on)) settings.push_back(line);
  }
  const RecordingHeader& header = reader->header();
  if (header.scene_text.empty())
    return failure(file.string(),
                   filled_in("it was written by {} and has no scene to go on with", header.writer),
                   "go on with a recording of ribbon-record");
  auto scene = read_scene(file, header.scene_text, settings, header.scene_name);
  if (!scene) return tl::unexpected(scene.error());
  if (names_marks(*scene))
    return failure(file.string(),
                   "its scene still names marks of a drawing, which no recorder leaves in a "
                   "recording",
                   "record the scene anew");
  if (auto agree = check_agreement(file, header, *scene); !agree)
    return tl::unexpected(agree.error());
  return RecordedRun{file, *std::move(reader), *std::move(scene)};
}

RestSize RecordedRun::rest_size() const {
  return ribbon::rest_size(reader.header());
}

Result<std::optional<SimulatedFrames>> RecordedRun::simulated_again(
    int index, const std::function<bool(int done, int total)>& go_on) {
  auto frames = nearest_before(index, *this);
  if (!frames) return tl::unexpected(frames.error());
  Comparison comparison(*this);
  const int first = frames->index() + 1;
  Result<void> agree;
  if (first > 0)
    agree = comparison.positions_agree(frames->index(), frames->fastening().positions());
  while (agree && frames->index() < index) {
    const SimulatedFrame frame = frames->next();
    agree = comparison.numbers_agree(frame);
    if (agree) agree = comparison.positions_agree(frame.index, frame.positions);
    if (agree && go_on && !go_on(frame.index + 1 - first, index + 1 - first)) return std::nullopt;
  }
  if (!agree) return tl::unexpected(agree.error());
  return std::optional(*std::move(frames));
}

}  // namespace ribbon
