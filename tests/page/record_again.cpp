// record_again RECORDING NEW: simulates what a recording holds once more, with the recorded
// obstacle and as many frames, and records it under another name. Run in WebAssembly, it tells
// whether a page comes to the bits of the native recorder; and, by its summary, how fast.
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "commandline/tool.h"
#include "recorder/run/record_around.h"
#include "recorder/run/recorded_run.h"

namespace ribbon {

namespace {

// Those that the run was begun with.
std::vector<std::string> changed_settings(const RecordingReader& reader) {
  std::vector<std::string> settings;
  for (const Session& session : reader.sessions()) {
    std::istringstream lines(session.note.changed_settings);
    for (std::string line; std::getline(lines, line);) settings.push_back(line);
  }
  return settings;
}

Result<ExitCode> record_again(const std::string& file, const std::string& target) {
  auto run = RecordedRun::open(file);
  if (!run) return tl::unexpected(run.error());
  const RecordingHeader& header = run->reader.header();
  const NewRecording recording{.file = target,
                               .program = header.writer,
                               .settings = changed_settings(run->reader),
                               .overwrite = Overwrite::yes};
  const RunObserver observer{[](int, int, const FrameNumbers&) { return true; }};
  const auto statistics = record_around(header.obstacle, run->scene, recording, observer,
                                        {.frames = run->reader.frame_count()});
  if (!statistics) return tl::unexpected(statistics.error());
  std::printf("%s: %s\n", target.c_str(), summary_line(*statistics).c_str());
  return ExitCode::done;
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("record_again", [&]() -> ribbon::Result<ribbon::ExitCode> {
    if (argc != 3) return ribbon::failure("", "needs two names", "record_again RECORDING NEW");
    return ribbon::record_again(argv[1], argv[2]);
  });
}
