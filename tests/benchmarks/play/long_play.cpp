// benchmark_long_play [--frames N] [--few N] [--scratch FOLDER] [--json FILE] RECORDING: plays
// recordings of a few and of many frames (those of the RECORDING, forth and back, over and over)
// from end to end by ribbon-play, and prints what each task takes of time and, at most, of memory.
// Ends with 1 where the many take over 120 bytes a frame, and 4 MB, more than the few: there is an
// index of them, but nothing else may grow. docs/play.md shows the figures of 50 000 frames.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <vector>

#include "benchmarks/benchmark_main.h"
#include "playback/recording_reader.h"
#include "recorder/process.h"
#include "recording/writer/recording_writer.h"

namespace ribbon {
namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path recording;
  fs::path scratch = fs::temp_directory_path();
  int frames = 50'000;
  int few = 500;
};

void describe(CLI::App& app, Options& options) {
  app.add_option("RECORDING", options.recording, "whose frames are played")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--frames", options.frames, "how many")->check(CLI::Range(2, 1'000'000));
  app.add_option("--few", options.few, "and how few")->check(CLI::Range(1, 1'000'000));
  app.add_option("--scratch", options.scratch, "where they are recorded")
      ->check(CLI::ExistingDirectory);
}

// Frame `number` of going forth and back through `count` frames.
int forth_and_back(int number, int count) {
  const int turn = std::max(1, 2 * (count - 1));
  return std::min(number % turn, turn - number % turn);
}

Result<void> record(const fs::path& path, RecordingReader& reader, int frames) {
  auto writer = RecordingWriter::create(path, reader.header());
  if (!writer) return tl::unexpected(writer.error());
  for (int frame = 0; frame < frames; ++frame) {
    const int index = forth_and_back(frame, reader.frame_count());
    const auto quantised = reader.read_quantised(index);
    if (!quantised) return tl::unexpected(quantised.error());
    FrameNumbers numbers = reader.numbers(index).value_or(FrameNumbers{});
    numbers.time_s = frame / reader.header().frames_per_second;
    if (auto appended = writer->append(numbers, **quantised); !appended) return appended;
  }
  return writer->finish();
}

struct Cost {
  double seconds = 0;
  double megabytes = 0;
};

Result<Cost> cost_of(const std::vector<std::string>& words) {
  const auto start = std::chrono::steady_clock::now();
  const Ended ended = end_of(spawned(words, StandardOutput::thrown_away));
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  // Its answer may be no, as of a recording that is not certified.
  if (ended.exit_code < 0 || ended.exit_code > static_cast<int>(ExitCode::answer_is_no))
    return failure(words[0], "did not do its task", "run it alone");
  return Cost{elapsed.count(), ended.most_memory / (1 << 20)};
}

struct Task {
  const char* name;
  std::vector<std::string> options;
};

const std::array tasks{
    Task{"info", {"--info"}},
    Task{"verify the last frame", {"--verify", "--frames", "-1"}},
    Task{"plot", {"--plot", "plot.svg", "--force", "--quiet"}},
    Task{"draft, raw, 64x36", {"-o", "-", "--quality", "draft", "--size", "64x36", "--quiet"}},
    Task{"preview, raw, 64x36", {"-o", "-", "--preview", "--size", "64x36", "--quiet"}},
};

Result<Cost> cost_of(const Task& task, const Options& options, const fs::path& recording) {
  std::vector<std::string> words{RIBBON_PLAY, recording};
  for (const std::string& option : task.options)
    words.push_back(option == "plot.svg" ? (options.scratch / option).string() : option);
  return cost_of(words);
}

Result<Findings> measure(const Options& options) {
  auto reader = RecordingReader::open(options.recording);
  if (!reader) return tl::unexpected(reader.error());
  const fs::path few = options.scratch / "few.rbn";
  const fs::path many = options.scratch / "many.rbn";
  for (const auto& [path, frames] : {std::pair{few, options.few}, std::pair{many, options.frames}})
    if (auto recorded = record(path, *reader, frames); !recorded)
      return tl::unexpected(recorded.error());
  Findings findings;
  std::printf("%-24s%10s%10s%12s\n", "", "MB, few", "MB, many", "frames/s");
  for (const Task& task : tasks) {
    const auto small = cost_of(task, options, few);
    if (!small) return tl::unexpected(small.error());
    const auto large = cost_of(task, options, many);
    if (!large) return tl::unexpected(large.error());
    const double rate = options.frames / large->seconds;
    std::printf("%-24s%10.1f%10.1f%12.0f\n", task.name, small->megabytes, large->megabytes, rate);
    std::fflush(stdout);
    findings.report[task.name] = {
        {"few_mb", small->megabytes}, {"many_mb", large->megabytes}, {"frames_per_s", rate}};
    const double allowed = 4 + 120e-6 * (options.frames - options.few);
    if (large->megabytes > small->megabytes + allowed) findings.code = ExitCode::answer_is_no;
  }
  fs::remove(few);
  fs::remove(many);
  return findings;
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::benchmark_main<ribbon::Options>("benchmark_long_play", argc, argv,
                                                 ribbon::describe, ribbon::measure);
}
