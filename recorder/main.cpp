// ribbon-record: fastens the ribbon of a scene and records every frame.
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "commandline/interrupt.h"
#include "commandline/progress.h"
#include "commandline/tool.h"
#include "files/files.h"
#include "files/pending_file.h"
#include "parallel/parallel.h"
#include "playback/recording_reader.h"
#include "recorder/branch.h"
#include "recorder/options.h"
#include "recorder/page/write_sketch_page.h"
#include "recorder/record.h"
#include "recorder/resume.h"
#include "recorder/show_crossings.h"
#include "scene/scene.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

std::string remark_on(const FrameNumbers& numbers) {
  return filled_in("strain {:.1f} %, penetrations {}", 100 * numbers.worst_strain,
                   numbers.penetrating_edges);
}

// Draws the progress of a run, and ends it when Ctrl-C is pressed.
class Watch {
 public:
  explicit Watch(ProgressStyle style) : style_(style) {}

  RunObserver observer() {
    return {[this](int done, int total, const FrameNumbers& numbers) {
              line(total, "frame").update(done, remark_on(numbers));
              return goes_on();
            },
            [this](int done, int total) {
              line(total, "frame simulated again").update(done);
              return goes_on();
            },
            [this](const std::string& what) {
              line(1, "start").update(0, what);
              return goes_on();
            }};
  }
  void end() {
    if (line_) line_->end();
  }
  [[nodiscard]] bool is_interrupted() const { return interrupt_ && interrupt_->requested(); }

 private:
  ProgressLine& line(int total, const std::string& unit) {
    if (!line_ || unit != unit_) {
      end();
      line_.emplace(unit, total, style_);
      unit_ = unit;
    }
    return *line_;
  }

  bool goes_on() {
    if (!interrupt_) interrupt_.emplace();
    return !interrupt_->requested();
  }

  ProgressStyle style_;
  std::string unit_;
  std::optional<ProgressLine> line_;
  std::optional<Interrupt> interrupt_;
};

bool is_recording(const std::filesystem::path& file) {
  std::error_code code;
  return std::filesystem::is_regular_file(file, code) && RecordingReader::open(file);
}

// A recording in the place of the scene would be refused as wrong TOML.
Result<void> is_no_recording(const std::filesystem::path& scene) {
  if (!is_recording(scene)) return {};
  return failure(scene.string(), "is a recording, not a scene",
                 "go on with it by --resume, branch a new take off by --from, or name a scene "
                 "(.toml)");
}

// What becomes of one that has the name of what is written, also where it came meanwhile.
Older older_file(const RecorderOptions& options) {
  return options.force ? Older::is_replaced : Older::stays;
}

// What is written takes the place of no file of the scene, not even by --force.
Result<Scene> read_scene_apart(const RecorderOptions& options) {
  if (auto other = is_no_recording(options.input); !other) return tl::unexpected(other.error());
  return read_scene(options.input, options.settings).and_then([&](Scene scene) -> Result<Scene> {
    for (const auto& file : files_of(scene))
      for (const auto& output : {options.recording, options.diagram, options.statistics})
        if (!output.empty() && is_same_file(output, file))
          return failure(output.string(), "is a file of the scene, which would be lost",
                         "name another file to write");
    return scene;
  });
}

Result<std::optional<RunStatistics>> run_task(const RecorderOptions& options,
                                              const RunObserver& observer) {
  constexpr const char* program = "ribbon-record " RIBBON_VERSION;
  if (options.task == RecorderTask::resume)
    return resume(options.recording, program, observer, options.limit);
  const NewRecording recording{.file = options.recording,
                               .program = program,
                               .settings = options.settings,
                               .overwrite = options.force ? Overwrite::yes : Overwrite::no};
  if (options.task == RecorderTask::branch)
    return branch(options.input, options.from_frame, recording, observer, options.limit);
  const auto scene = read_scene_apart(options);
  if (!scene) return tl::unexpected(scene.error());
  auto statistics = record(*scene, recording, observer, options.limit);
  if (!statistics) return tl::unexpected(statistics.error());
  return std::optional(*std::move(statistics));
}

std::string nothing_done(const RecorderOptions& options) {
  return options.task == RecorderTask::resume
             ? nothing_to_add(options.recording)
             : "ended by the user before there was anything to record";
}

// Not where a limit or the run itself ended it, nor where nothing was left to do.
bool is_interrupted(const std::optional<RunStatistics>& run, const Watch& watch) {
  if (!run) return watch.is_interrupted();
  return run->ending == RunEnding::stopped;
}

Result<ExitCode> do_crossings(const RecorderOptions& options) {
  const auto text = read_scene_apart(options).and_then([&](const Scene& scene) {
    return show_crossings(scene, options.diagram, older_file(options));
  });
  if (!text) return tl::unexpected(text.error());
  if (!options.quiet) std::fputs(text->c_str(), stdout);
  return ExitCode::done;
}

Result<ExitCode> do_draw(const RecorderOptions& options) {
  const auto scene = options.input.empty() ? Result<std::optional<Scene>>()
                                           : read_scene_apart(options).map([](Scene read) {
                                               return std::optional(std::move(read));
                                             });
  const auto text = scene.and_then([&](const std::optional<Scene>& begun) {
    return write_sketch_page(begun, options.recording, older_file(options));
  });
  if (!text) return tl::unexpected(text.error());
  if (!options.quiet) std::fputs(text->c_str(), stdout);
  return ExitCode::done;
}

// Those that were recorded before are not simulated anew.
void warn_of_lost_frames(RecordingReader& reader, const std::filesystem::path& file) {
  reader.check();
  std::vector<int> lost;
  for (int frame = 0; frame < reader.frame_count(); ++frame)
    if (!reader.readable(frame)) lost.push_back(frame + 1);
  if (lost.empty()) return;
  std::fprintf(stderr,
               "ribbon-record: %s: frames %s are lost; record the scene anew to have them again\n",
               file.c_str(), number_list(lost).c_str());
}

// Where standard output is the recording itself, as a file or a pipe, a sentence would damage it.
std::FILE* stream_apart_from(const std::filesystem::path& recording) {
  struct stat named {};
  struct stat output {};
  const bool is_same = ::stat(recording.c_str(), &named) == 0 &&
                       ::fstat(STDOUT_FILENO, &output) == 0 && named.st_dev == output.st_dev &&
                       named.st_ino == output.st_ino;
  return is_same ? stderr : stdout;
}

// Asked before the run, which may be long.
Result<void> check_place_of_statistics(const RecorderOptions& options) {
  const std::filesystem::path& file = options.statistics;
  if (file.empty()) return {};
  for (const auto& other : {options.recording, options.input})
    if (!other.empty() && is_same_file(file, other))
      return failure(file.string(), "is " + other.string() + ", in whose place figures cannot go",
                     "name another file after --stats");
  // --force may be meant for what -o names.
  if (is_recording(file))
    return failure(file.string(), "is a recording, in whose place figures cannot go",
                   "name another file after --stats");
  std::error_code code;
  if (is_taken(file) && !std::filesystem::is_directory(file, code) && !options.force)
    return failure(file.string(), "exists already",
                   "name another file after --stats, or replace it by --force");
  return PendingFile::create(file).map([](const PendingFile&) {});
}

Result<ExitCode> do_task(const RecorderOptions& options) {
  if (options.task == RecorderTask::draw) return do_draw(options);
  if (options.task == RecorderTask::crossings) return do_crossings(options);
  if (auto place = check_place_of_statistics(options); !place) return tl::unexpected(place.error());
  set_thread_limit(options.threads);
  Watch watch(options.progress);
  auto statistics = run_task(options, watch.observer());
  watch.end();
  if (!statistics) return tl::unexpected(statistics.error());
  std::optional<RunStatistics>& run = *statistics;
  const bool interrupted = is_interrupted(run, watch);
  if (auto reader = RecordingReader::open(options.recording)) {
    if (run) run->outcome = outcome(*reader);
    if (options.task == RecorderTask::resume) warn_of_lost_frames(*reader, options.recording);
  }
  std::FILE* const told = stream_apart_from(options.recording);
  if (!options.quiet)
    std::fprintf(told, "%s: %s\n", options.recording.c_str(),
                 (run ? summary_line(*run) : nothing_done(options)).c_str());
  if (run && options.profile) std::fputs(profile_text(*run).c_str(), told);
  if (run && !options.statistics.empty())
    if (auto written = write_file(options.statistics, statistics_json(*run), older_file(options));
        !written)
      return tl::unexpected(written.error());
  return interrupted ? ExitCode::try_again : ExitCode::done;
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("ribbon-record", [&]() -> ribbon::Result<ribbon::ExitCode> {
    const auto options = ribbon::parse_recorder_options(argc, argv);
    if (!options) return tl::unexpected(options.error());
    return *options ? ribbon::do_task(**options) : ribbon::ExitCode::done;
  });
}
