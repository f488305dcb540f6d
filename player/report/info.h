// What a recording holds, for people and for programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "inspection/outcome.h"
#include "playback/recording_reader.h"

namespace ribbon {

// A worst value and the frame that has it, numbered from 1.
struct WorstFrame {
  double value = 0;
  int frame = 0;
};

// Frames in a row that lie in a stage of fastening; all from 1.
struct StageFrames {
  int number = 0;
  std::string name;
  int first = 0;
  int last = 0;
};

struct RecordingInfo {
  std::filesystem::path file;
  std::uint64_t file_bytes = 0;
  std::uint32_t recording_id = 0;
  bool finished = false;
  bool being_written = false;  // at this moment
  RunEnding ending = RunEnding::unknown;
  RecordingHeader header;
  std::vector<std::optional<FrameNumbers>> numbers;  // one per frame; nothing where it is lost
  std::vector<int> missing;                          // numbers, from 1, of frames that are lost
  std::vector<Damage> damage;
  std::vector<int> checkpoints;  // numbers, from 1, of the frames that have one
  std::vector<Session> sessions;
  std::optional<Outcome> outcome;             // nothing also where nobody asked
  std::optional<std::uint64_t> memory_bytes;  // that pictures will take; nothing: nobody asked

  [[nodiscard]] int frame_count() const { return static_cast<int>(numbers.size()); }
  // From the first to the last frame whose numbers are known; 0 without any.
  [[nodiscard]] double duration_s() const;
  // Nothing where no frame's numbers are known.
  [[nodiscard]] std::optional<WorstFrame> worst_strain() const;
  [[nodiscard]] std::optional<WorstFrame> most_penetrations() const;
  [[nodiscard]] std::optional<std::uint32_t> last_penetrations() const;
  // Of the last frame whose numbers are known; nothing where there is none or it tells none.
  [[nodiscard]] std::optional<TightnessNumbers> last_tightness() const;
  // Those that frames are known to lie in, in their order; one comes again where a take has gripped
  // again after frames of no stage.
  [[nodiscard]] std::vector<StageFrames> stages() const;
  // Size of the file over particles and frames; 0 without frames.
  [[nodiscard]] double bytes_per_vertex_and_frame() const;
};

// Reads every record once, so that a frame that is said to be there is. How the run came out is
// left open: outcome() decodes frames for it.
RecordingInfo recording_info(const std::filesystem::path& file, RecordingReader& reader);

// Several lines to read.
std::string info_text(const RecordingInfo& info);

// One JSON object; what is not known is null.
std::string info_json(const RecordingInfo& info);

}  // namespace ribbon
