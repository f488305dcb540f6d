// A recording becomes files for modelling packages.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "commandline/progress.h"
#include "files/part_file.h"
#include "model/model.h"
#include "playback/recording_reader.h"
#include "result/result.h"

namespace ribbon {

struct ConversionRequest {
  std::filesystem::path recording;
  std::string output;  // "out/knot.{frame:04}.obj", "out/knot.abc"
  std::string frames;  // "A:B:STEP"; empty: all
  // Of which these are some: those that the recording has gained since are not asked for.
  std::optional<int> frame_count = {};
  ModelSettings model;                               // its pictures are read from the textures
  static constexpr double least_thickness_m = 1e-6;  // of a solid, that may be asked for
  static constexpr double most_thickness_m = 1;
  std::filesystem::path texture = {};       // of the ribbon; empty: none
  std::filesystem::path texture_back = {};  // of a solid's back; empty: the same
  std::optional<int> start_frame;  // number of the first file of a sequence; otherwise as recorded
  double max_error_m = 0;          // of positions in a recording; 0: as they were recorded
  static constexpr double least_max_error_m = 1e-9;  // that may be asked for
  bool force = false;                                // what exists may be replaced
  bool resume = false;                               // goes on with a sequence that was stopped
  ProgressStyle progress = ProgressStyle::line;
  std::function<bool()> interrupted = [] { return false; };  // asked before each frame; any thread

  // What has come since the places were looked at. A sequence that goes on replaces its own files.
  [[nodiscard]] Older later() const { return force || resume ? Older::is_replaced : Older::stays; }
};

struct ConversionReport {
  int frame_count = 0;      // that the recording had
  int frames_written = 0;   // or kept
  int frames_repeated = 0;  // others in the place of frames that one file cannot leave out
  int frames_kept = 0;      // complete before this conversion went on
  std::uint64_t bytes_written = 0;
  std::filesystem::path first_file;
  std::filesystem::path last_file;
  std::vector<std::string>
      remarks;       // a sentence each: of the recording, and of what other programs do
  int left_out = 0;  // of a recording: most frames in a row between two that are kept
  std::optional<double> least_thickness_m;  // of a solid ribbon in the frames written now
  int most_pinched = 0;        // particles of one frame where front and back of the solid touch
  std::vector<int> refused;    // numbers (from 1) of asked frames that cannot be made a solid
  std::vector<int> missing;    // likewise, that the damaged recording lost
  std::vector<Damage> damage;  // of the recording
};

// Writes every asked frame that can be read, and made a solid if that is asked for, on all cores.
// Each file appears complete or not at all, and none is replaced unasked. Fails, naming the place,
// when the recording cannot be opened or holds none of the frames, when the output exists or cannot
// be written, when the format has no place for what is asked, when a frame is not finite, or when
// interrupted.
Result<ConversionReport> convert(const ConversionRequest& request);

}  // namespace ribbon
