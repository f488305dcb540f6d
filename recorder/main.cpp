// ribbon-record: fastens the ribbon of a scene and records every frame.
#include <cstdio>
#include <string>

#include "commandline/interrupt.h"
#include "commandline/number_text.h"
#include "commandline/progress.h"
#include "commandline/tool.h"
#include "files/files.h"
#include "parallel/parallel.h"
#include "recorder/options.h"
#include "recorder/record.h"

namespace ribbon {

namespace {

std::string remark_on(const FrameNumbers& numbers) {
  return "strain " + decimals(100 * numbers.worst_strain, 1) + " %, penetrations " +
         std::to_string(numbers.penetrating_edges);
}

Result<ExitCode> record_scene(const RecorderOptions& options) {
  set_thread_limit(options.threads);
  const auto scene = read_scene(options.scene);
  if (!scene) return tl::unexpected(scene.error());

  ProgressLine progress("frame", frame_count(*scene), options.quiet);
  const Interrupt interrupt;
  const RunObserver observer{[&](int done, int /*total*/, const FrameNumbers& numbers) {
    progress.update(done, remark_on(numbers));
    return !interrupt.requested();
  }};
  const auto statistics =
      record(*scene, options.recording, "ribbon-record " RIBBON_VERSION, observer);
  progress.clear();
  if (!statistics) return tl::unexpected(statistics.error());

  if (!options.quiet)
    std::printf("%s: %s\n", options.recording.c_str(), summary_line(*statistics).c_str());
  if (options.profile) std::fputs(profile_text(*statistics).c_str(), stdout);
  if (!options.statistics.empty())
    if (auto written = write_file(options.statistics, statistics_json(*statistics)); !written)
      return tl::unexpected(written.error());
  return ExitCode::done;
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("ribbon-record", [&]() -> ribbon::Result<ribbon::ExitCode> {
    const auto options = ribbon::parse_options(argc, argv);
    if (!options) return tl::unexpected(options.error());
    return *options ? ribbon::record_scene(**options) : ribbon::ExitCode::done;
  });
}
