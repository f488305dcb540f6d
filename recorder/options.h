// What the user asks ribbon-record for.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "commandline/progress.h"
#include "recorder/run/run_plan.h"
#include "result/result.h"

namespace ribbon {

enum class RecorderTask {
  record,     // a scene
  resume,     // a recording
  branch,     // a new take off a recording
  crossings,  // show those of a scene's drawing, and nothing else
  draw        // a page in which a drawing is made
};

struct RecorderOptions {
  RecorderTask task = RecorderTask::record;
  std::filesystem::path input;        // the scene or the recording to branch off; else empty
  std::filesystem::path recording;    // to write; or the page
  std::filesystem::path diagram;      // of the crossings, to write
  int from_frame = 0;                 // to branch off at, from 0
  std::vector<std::string> settings;  // to change in the scene, or there: "key=value"
  bool force = false;                 // replace an older recording, older figures
  RunLimit limit;
  std::filesystem::path statistics;  // JSON file to write at the end; empty: none
  int threads = 0;                   // 0: all cores
  bool profile = false;
  bool quiet = false;
  ProgressStyle progress = ProgressStyle::line;
};

// Nothing when --help or --version was asked for: that has been printed to standard output. Fails
// when the command line cannot be understood or asks for things that do not go together.
Result<std::optional<RecorderOptions>> parse_recorder_options(int argc, const char* const* argv);

}  // namespace ribbon
