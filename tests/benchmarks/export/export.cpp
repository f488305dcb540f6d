// benchmark_export [--frames N] [--rounds N] [--scratch FOLDER] [--json FILE] RECORDING: what each
// export format takes for the first N frames (those of the RECORDING, over and over), beside
// writing as many bytes that are there already, and OBJ beside assimp's own. Times are what passes,
// waiting for the disk included, and what the processor works, for user and system together, each
// of the quickest of the rounds; reading the recording is not counted. Each is measured in a
// process of its own, whose largest memory is told. docs/export.md shows the figures.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>

#include "benchmarks/benchmark_main.h"
#include "benchmarks/export/assimp_obj.h"
#include "converter/export/fbx_writer.h"
#include "converter/motion_format.h"
#include "files/pending_file.h"
#include "model/obj_text.h"
#include "playback/recording_reader.h"
#include "recorder/process.h"
#include "result/demanded.h"

namespace ribbon {
namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path recording;
  fs::path scratch = fs::temp_directory_path();
  int frames = 600;
  int rounds = 3;
};

void describe(CLI::App& app, Options& options) {
  app.add_option("RECORDING", options.recording, "whose frames are exported")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--frames", options.frames, "how many")->check(CLI::Range(1, 1'000'000));
  app.add_option("--rounds", options.rounds, "the quickest counts")->check(CLI::Range(1, 100));
  app.add_option("--scratch", options.scratch, "where files are written that are measured")
      ->check(CLI::ExistingDirectory);
}

// On a clock, and of the processor on all cores.
struct Seconds {
  double elapsed = 0;
  double processor = 0;
};

Seconds now() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  const std::chrono::duration<double> clock = std::chrono::steady_clock::now().time_since_epoch();
  return {.elapsed = clock.count(), .processor = seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

void add_what_passed_since(const Seconds& start, Seconds& sum) {
  const Seconds end = now();
  sum.elapsed += end.elapsed - start.elapsed;
  sum.processor += end.processor - start.processor;
}

void keep_the_quicker(const Seconds& seconds, Seconds& quickest) {
  quickest.elapsed = std::min(quickest.elapsed, seconds.elapsed);
  quickest.processor = std::min(quickest.processor, seconds.processor);
}

// Frame after frame of a recording, posed; the time that is spent on each is measured.
class Motion {
 public:
  explicit Motion(const Options& options)
      : options_(options),
        reader_(demanded(RecordingReader::open(options.recording))),
        model_(demanded(model_of_recording(reader_.header(), {}))) {
    pose(0);
  }

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] int frames() const { return options_.frames; }
  [[nodiscard]] Seconds seconds() const { return seconds_; }

  template <class Work>
  void timed(const Work& work) {
    const Seconds start = now();
    demanded(Result<void>(work()));
    add_what_passed_since(start, seconds_);
  }

  template <class Work>
  void timed_for_each_frame(const Work& work) {
    for (int frame = 0; frame < options_.frames; ++frame) {
      pose(frame);
      timed([&] { return work(frame); });
    }
  }

 private:
  void pose(int frame) {
    Eigen::Matrix3Xf positions;
    demanded(reader_.read(frame % reader_.frame_count(), positions));
    demanded(pose_ribbon(model_, positions, frame + 1));
  }

  const Options& options_;
  RecordingReader reader_;
  Model model_;
  Seconds seconds_;
};

// Writes all frames into a folder.
struct Format {
  std::string name;
  std::function<void(Motion& motion, const fs::path& folder)> write;
};

Format whole_motion(const MotionFormat& format) {
  const std::string extension(format.extension);
  return {extension, [format, extension](Motion& motion, const fs::path& folder) {
            std::unique_ptr<MotionWriter> writer;
            motion.timed([&] {
              writer = demanded(
                  format.new_writer(folder / ("a" + extension), motion.model(), motion.frames()));
              return Result<void>{};
            });
            motion.timed_for_each_frame([&](int) { return writer->append(motion.model()); });
            motion.timed([&] { return writer->finish(); });
          }};
}

template <class Write>
Format sequence(const std::string& name, const std::string& extension, Write write) {
  return {name, [=](Motion& motion, const fs::path& folder) {
            motion.timed_for_each_frame([&](int frame) {
              return write(motion.model(), folder / (std::to_string(frame) + extension));
            });
          }};
}

std::vector<Format> formats() {
  std::vector<Format> formats;
  for (const MotionFormat& format : motion_formats()) formats.push_back(whole_motion(format));
  const auto write_fbx = [](const Model& model, const fs::path& path) {
    return fbx_bytes(model).and_then(
        [&](const std::string& bytes) { return write_file(path, bytes); });
  };
  const auto write_obj = [](const Model& model, const fs::path& path) {
    return write_file(path, obj_text(model, "a.mtl"));
  };
  formats.push_back(sequence(".fbx, a file a frame", ".fbx", write_fbx));
  formats.push_back(sequence(".obj, a file a frame", ".obj", write_obj));
  formats.push_back(sequence(".obj by assimp", ".obj", write_obj_by_assimp));
  return formats;
}

// As many files as there are, with as many bytes.
void write_raw(const fs::path& like, const fs::path& folder) {
  const std::string piece(1 << 16, 'x');
  for (const auto& entry : fs::directory_iterator(like)) {
    auto file = demanded(PendingFile::create(folder / entry.path().filename()));
    for (std::uintmax_t left = entry.file_size(); left > 0;) {
      const std::size_t bytes = std::min<std::uintmax_t>(left, piece.size());
      demanded(file.append({piece.data(), bytes}));
      left -= bytes;
    }
    demanded(file.finish());
  }
}

constexpr double forever = std::numeric_limits<double>::infinity();

struct Figures {
  Seconds seconds{.elapsed = forever, .processor = forever};
  Seconds raw = seconds;
  double bytes = 0;
  double largest_memory = 0;  // bytes
};

// The seconds that `work` says it took, in a process of its own, and that one's largest memory.
template <class Work>
std::pair<Seconds, double> in_own_process(const Work& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) std::exit(2);
  const pid_t child = fork();
  if (child == 0) {
    const Seconds seconds = work();
    const bool told = write(ends[1], &seconds, sizeof seconds) == sizeof seconds;
    _exit(told ? 0 : 2);
  }
  Seconds seconds;
  close(ends[1]);
  const bool told = read(ends[0], &seconds, sizeof seconds) == sizeof seconds;
  close(ends[0]);
  const Ended ended = end_of(child);
  if (!told || ended.exit_code != 0) std::exit(2);
  return {seconds, ended.most_memory};
}

Figures measure(const Format& format, const Options& options) {
  const fs::path folder = options.scratch / "benchmark_export";
  const fs::path raw = options.scratch / "benchmark_export_raw";
  Figures figures;
  for (int round = 0; round < options.rounds; ++round) {
    for (const fs::path& place : {folder, raw}) {
      fs::remove_all(place);
      fs::create_directories(place);
    }
    const auto [seconds, memory] = in_own_process([&] {
      Motion motion(options);
      format.write(motion, folder);
      return motion.seconds();
    });
    const auto [raw_seconds, raw_memory] = in_own_process([&] {
      Seconds spent;
      const Seconds start = now();
      write_raw(folder, raw);
      add_what_passed_since(start, spent);
      return spent;
    });
    keep_the_quicker(seconds, figures.seconds);
    keep_the_quicker(raw_seconds, figures.raw);
    figures.largest_memory = memory;
  }
  for (const auto& entry : fs::directory_iterator(folder))
    figures.bytes += static_cast<double>(entry.file_size());
  fs::remove_all(folder);
  fs::remove_all(raw);
  return figures;
}

void print(const std::string& format, const Figures& figures, int frames) {
  const auto ms_a_frame = [frames](double seconds) { return 1e3 * seconds / frames; };
  std::printf("| `%s` | %.3f | %.3f | %.3f | %.1f | %.3f | %.3f | %.1f | %.0f |\n", format.c_str(),
              1e-6 * figures.bytes / frames, ms_a_frame(figures.seconds.elapsed),
              ms_a_frame(figures.raw.elapsed), figures.seconds.elapsed / figures.raw.elapsed,
              ms_a_frame(figures.seconds.processor), ms_a_frame(figures.raw.processor),
              figures.seconds.processor / figures.raw.processor, 1e-6 * figures.largest_memory);
  std::fflush(stdout);
}

Result<Findings> run(const Options& options) {
  std::puts(
      "| to | MB a frame | ms a frame | raw | ratio | processor ms | raw | ratio | peak MB |\n"
      "|---|---|---|---|---|---|---|---|---|");
  Findings findings;
  for (const Format& format : formats()) {
    const Figures figures = measure(format, options);
    print(format.name, figures, options.frames);
    findings.report.push_back({{"format", format.name},
                               {"frames", options.frames},
                               {"elapsed_s", figures.seconds.elapsed},
                               {"raw_elapsed_s", figures.raw.elapsed},
                               {"processor_s", figures.seconds.processor},
                               {"raw_processor_s", figures.raw.processor},
                               {"bytes", figures.bytes},
                               {"largest_memory", figures.largest_memory}});
  }
  return findings;
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::benchmark_main<ribbon::Options>("benchmark_export", argc, argv, ribbon::describe,
                                                 ribbon::run);
}
