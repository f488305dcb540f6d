// benchmark_export [--frames N] [--rounds N] [--scratch FOLDER] [--json FILE] RECORDING: what each
// export format takes for the first N frames (those of the RECORDING, over and over), beside
// writing as many bytes that are there already, and OBJ beside assimp's own. Times are the
// processor's, for user and system together, of the quickest of the rounds; reading the recording
// is not counted. Each is measured in a process of its own, whose largest memory is told.
// docs/export.md shows the figures.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <limits>

#include "benchmarks/benchmark_main.h"
#include "benchmarks/export/assimp_obj.h"
#include "converter/export/fbx_writer.h"
#include "converter/export/obj_text.h"
#include "converter/motion_format.h"
#include "files/pending_file.h"
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

double processor_s() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
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
  [[nodiscard]] double seconds() const { return seconds_; }

  template <class Work>
  void timed(const Work& work) {
    const double start_s = processor_s();
    demanded(Result<void>(work()));
    seconds_ += processor_s() - start_s;
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
  double seconds_ = 0;
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

struct Figures {
  double seconds = std::numeric_limits<double>::infinity();
  double raw_s = std::numeric_limits<double>::infinity();
  double bytes = 0;
  double largest_memory = 0;  // bytes
};

// The seconds that `work` says it took, in a process of its own, and that one's largest memory.
template <class Work>
std::pair<double, double> in_own_process(const Work& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) std::exit(2);
  const pid_t child = fork();
  if (child == 0) {
    const double seconds = work();
    const bool told = write(ends[1], &seconds, sizeof seconds) == sizeof seconds;
    _exit(told ? 0 : 2);
  }
  double seconds = 0;
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
    const auto [raw_s, raw_memory] = in_own_process([&] {
      const double start_s = processor_s();
      write_raw(folder, raw);
      return processor_s() - start_s;
    });
    figures.seconds = std::min(figures.seconds, seconds);
    figures.raw_s = std::min(figures.raw_s, raw_s);
    figures.largest_memory = memory;
  }
  for (const auto& entry : fs::directory_iterator(folder))
    figures.bytes += static_cast<double>(entry.file_size());
  fs::remove_all(folder);
  fs::remove_all(raw);
  return figures;
}

Result<Findings> run(const Options& options) {
  std::puts(
      "| to | ms a frame | as raw bytes | MB a frame | peak memory, MB |\n|---|---|---|---|---|");
  Findings findings;
  for (const Format& format : formats()) {
    const Figures figures = measure(format, options);
    const double frames = options.frames;
    std::printf("| `%s` | %.3f | %.3f | %.3f | %.0f |\n", format.name.c_str(),
                1e3 * figures.seconds / frames, 1e3 * figures.raw_s / frames,
                1e-6 * figures.bytes / frames, 1e-6 * figures.largest_memory);
    std::fflush(stdout);
    findings.report.push_back({{"format", format.name},
                               {"frames", options.frames},
                               {"seconds", figures.seconds},
                               {"raw_s", figures.raw_s},
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
