#include "recorder/recorded_run.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "recorder/start.h"
#include "recording/codec/position_encoder.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

// From a checkpoint, or why not.
Result<SimulatedFrames> from_checkpoint(const RecordingReader& reader, const Scene& scene,
                                        std::uint32_t frame) {
  const auto checkpoint = reader.read_checkpoint(frame);
  if (!checkpoint) return tl::unexpected(checkpoint.error());
  auto fastening = FasteningProcessor::restore(scene, rest_size_of(reader.header()),
                                               reader.header().obstacle, checkpoint->state);
  if (!fastening) return tl::unexpected(fastening.error());
  return SimulatedFrames(scene, *std::move(fastening), static_cast<int>(frame));
}

Result<SimulatedFrames> from_drawing(const fs::path& path, const RecordingReader& reader,
                                     const Scene& scene) {
  const RecordingHeader& header = reader.header();
  if (header.origin)
    return failure(path.string(),
                   "there is no usable checkpoint of what was recorded since it branched off",
                   "branch off from '" + header.origin->scene_name + "' once more");
  auto start = find_start(scene, header.obstacle);
  if (!start) {
    start.error().problem = "there is no usable checkpoint, and the start cannot be made again: " +
                            start.error().place + ": " + start.error().problem;
    start.error().place = path.string();
    return tl::unexpected(start.error());
  }
  if (!(start->ribbon.grid == header.grid) || start->ribbon.length_m != header.ribbon_length_m ||
      start->ribbon.width_m != header.ribbon_width_m)
    return failure(path.string(),
                   "there is no usable checkpoint, and the drawing is not the one it was recorded "
                   "from",
                   "record the scene anew");
  return SimulatedFrames(scene, std::move(start->fastening), -1);
}

// From the last checkpoint at or before the frame that can be used.
Result<SimulatedFrames> nearest_before(const fs::path& path, const RecordingReader& reader,
                                       const Scene& scene, int index) {
  std::vector<std::uint32_t> checkpoints = reader.checkpoints();
  std::sort(checkpoints.rbegin(), checkpoints.rend());
  for (const std::uint32_t frame : checkpoints) {
    if (static_cast<int>(frame) > index) continue;
    auto frames = from_checkpoint(reader, scene, frame);
    if (frames) return frames;
  }
  return from_drawing(path, reader, scene);
}

// Compares frames with recorded ones, as they were decoded.
class Comparison {
 public:
  Comparison(fs::path path, RecordingReader& reader)
      : path_(std::move(path)),
        reader_(reader),
        encoder_(codec_parameters(reader.header()), reader.header().max_position_error_m) {}

  [[nodiscard]] Result<void> numbers_agree(const SimulatedFrame& frame) const {
    const auto recorded = reader_.numbers(frame.index);
    if (!recorded || *recorded == frame.numbers) return {};
    return otherwise(frame.index);
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
    return failure(path_.string() + ": frame " + std::to_string(index + 1),
                   "simulated again, it comes out otherwise than recorded",
                   "go on with the program that recorded it, " + reader_.header().writer +
                       ", on the same kind of processor");
  }

  fs::path path_;
  RecordingReader& reader_;
  PositionEncoder encoder_;
  Eigen::Matrix3Xf recorded_;
  Eigen::Matrix3Xf simulated_;
};

}  // namespace

RestSize rest_size_of(const RecordingHeader& header) {
  return {header.grid, header.ribbon_length_m, header.ribbon_width_m};
}

Result<Scene> recorded_scene(const fs::path& path, const RecordingReader& reader) {
  std::vector<std::string> settings;
  for (const Session& session : reader.sessions())
    for (std::string& line : lines_of(session.note.changed_settings))
      settings.push_back(std::move(line));
  auto scene = read_scene(path, reader.header().scene_text, settings);
  if (scene) scene->name = reader.header().scene_name;
  return scene;
}

Result<std::optional<SimulatedFrames>> simulated_again(
    const fs::path& path, RecordingReader& reader, const Scene& scene, int index,
    const std::function<bool(int done, int total)>& go_on) {
  auto frames = nearest_before(path, reader, scene, index);
  if (!frames) return tl::unexpected(frames.error());
  Comparison comparison(path, reader);
  if (frames->index() >= 0)
    if (auto agree = comparison.positions_agree(frames->index(), frames->fastening().positions());
        !agree)
      return tl::unexpected(agree.error());
  const int first = frames->index() + 1;
  while (frames->index() < index) {
    const SimulatedFrame frame = frames->next();
    Result<void> agree = comparison.numbers_agree(frame);
    if (agree) agree = comparison.positions_agree(frame.index, frame.positions);
    if (!agree) return tl::unexpected(agree.error());
    if (go_on && !go_on(frame.index + 1 - first, index + 1 - first)) return std::nullopt;
  }
  return std::optional(*std::move(frames));
}

}  // namespace ribbon
