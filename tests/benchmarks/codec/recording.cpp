// benchmark_recording [--bounds B...] [--every N] [--long N] [--alone] [--scratch FOLDER] [--json
// FILE] RECORDING...: what a recording takes at several bounds on its error, beside other codecs on
// the same frames, and how long it takes to open one and to jump in it. The frames of the
// RECORDINGs are the truth, so these should be exact (bound 0). Exit code 1 when our own codec does
// not keep a bound, 2 when something could not be read or written. docs/recording.md shows the
// figures.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/benchmark_main.h"
#include "benchmarks/codec/codec_measurement.h"
#include "benchmarks/codec/own_codec.h"
#include "benchmarks/codec/peers.h"
#include "benchmarks/codec/recorded_motion.h"
#include "benchmarks/codec/whole_recording.h"

namespace ribbon {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> recordings;
  std::vector<double> bounds = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 0};
  int every = 2;
  int long_frames = 50'000;
  bool alone = false;
  std::filesystem::path scratch = std::filesystem::temp_directory_path();
};

constexpr double long_bound = 1e-5;

void describe(CLI::App& app, Options& options) {
  app.add_option("RECORDING", options.recordings, "whose frames are measured")->required();
  app.add_option("--bounds", options.bounds, "on the error, of the ribbon's length; 0: exact")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--every", options.every, "compare codecs on each n-th block of 80 frames")
      ->check(CLI::Range(1, 1'000'000));
  app.add_option("--long", options.long_frames, "frames of the long file that is opened")
      ->check(CLI::Range(1, 10'000'000));
  app.add_flag("--alone", options.alone, "measure no other codec, and no files");
  app.add_option("--scratch", options.scratch, "where files are written that are measured")
      ->check(CLI::ExistingDirectory);
}

std::vector<FrameSpan> blocks_of(FrameSpan frames, int every) {
  std::vector<FrameSpan> blocks;
  const std::size_t apart = std::size_t{block_frames} * every;
  for (std::size_t at = 0; at < frames.size(); at += apart)
    blocks.push_back(frames.subspan(at, std::min<std::size_t>(block_frames, frames.size() - at)));
  return blocks;
}

std::vector<CodecRow> peer_rows() {
  std::vector<CodecRow> rows;
  for (auto&& more : {byte_rows(), zfp_rows(), meshoptimizer_rows(), draco_rows()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

// The largest error over the bound; where nothing is allowed, 0 is all that can be.
double share_of_bound(double error_m, double bound_m) {
  return bound_m > 0 ? error_m / bound_m : error_m;
}

// One row for one bound; false where the row has nothing that keeps it.
bool measure_row(const CodecRow& row, const CodecTask& task, double bound,
                 const std::vector<FrameSpan>& blocks, Json& report) {
  const auto figures = measure(row, task, blocks);
  if (!figures) return false;
  const double error = share_of_bound(figures->worst_error_m, task.bound_m);
  std::printf("| %s | %g | %.2f | %.3g | %.3g | %.3f |\n", row.name.c_str(), bound, figures->bits,
              figures->encode_gb_per_s, figures->decode_gb_per_s, error);
  std::fflush(stdout);
  report.push_back({{"codec", row.name},
                    {"bound", bound},
                    {"bits", figures->bits},
                    {"encode_gb_per_s", figures->encode_gb_per_s},
                    {"decode_gb_per_s", figures->decode_gb_per_s},
                    {"worst_error_over_bound", error}});
  return true;
}

Json json_of(const FileFigures& file, double bound) {
  return {{"bound", bound},
          {"frames", file.frames},
          {"bits", file.bits},
          {"open_s", file.open_s},
          {"seek_median_s", file.seek_median_s},
          {"seek_p99_s", file.seek_p99_s}};
}

void print(const FileFigures& file, double bound) {
  std::printf("| %d frames | %g | %.2f | %.3g | %.3g | %.3g |\n", file.frames, bound, file.bits,
              1e3 * file.open_s, 1e3 * file.seek_median_s, 1e3 * file.seek_p99_s);
  std::fflush(stdout);
}

// All codecs at all bounds; false where our own did not keep one.
bool compare_codecs(const RecordedMotion& motion, const Options& options, Json& report) {
  std::puts(
      "\n| codec | bound | bits | encode, GB/s | decode, GB/s | worst error / bound |\n"
      "|---|---|---|---|---|---|");
  const auto blocks = blocks_of(motion.frames, options.every);
  const std::vector<CodecRow> peers = options.alone ? std::vector<CodecRow>() : peer_rows();
  bool keeps_bounds = true;
  for (const double bound : options.bounds) {
    const CodecTask task{motion.header.grid, motion.header, bound * motion.header.ribbon_length_m,
                         motion.largest_m(), motion.start_m()};
    keeps_bounds = measure_row(own_row(), task, bound, blocks, report) && keeps_bounds;
    for (const CodecRow& row : peers) measure_row(row, task, bound, blocks, report);
  }
  return keeps_bounds;
}

Result<void> measure_file(const RecordedMotion& motion, double bound, int frames,
                          const Options& options, Json& report) {
  const std::filesystem::path file = options.scratch / "benchmark_recording.rbn";
  const auto figures = measure_file(motion, bound * motion.header.ribbon_length_m, frames, file);
  std::filesystem::remove(file);
  if (!figures) return tl::unexpected(figures.error());
  print(*figures, bound);
  report.push_back(json_of(*figures, bound));
  return {};
}

Result<void> measure_files(const RecordedMotion& motion, const Options& options, Json& report) {
  std::puts(
      "\n| file | bound | bits | open, ms | seek, ms | 99th percentile, ms |\n"
      "|---|---|---|---|---|---|");
  const int frames = static_cast<int>(motion.frames.size());
  for (const double bound : options.bounds)
    if (auto done = measure_file(motion, bound, frames, options, report); !done) return done;
  return {};
}

Result<Findings> run(const Options& options) {
  Json report;
  ExitCode code = ExitCode::done;
  for (const std::string& path : options.recordings) {
    const auto motion = read_motion(path);
    if (!motion) return tl::unexpected(motion.error());
    const RecordingHeader& header = motion->header;
    std::printf("\n%s, %dx%d, %zu frames\n", header.scene_name.c_str(), header.grid.across,
                header.grid.along, motion->frames.size());
    Json figures = {{"name", header.scene_name}, {"frames", motion->frames.size()}};
    if (!compare_codecs(*motion, options, figures["codecs"])) code = ExitCode::answer_is_no;
    report["recordings"].push_back(figures);
    if (options.alone) continue;
    if (auto done = measure_files(*motion, options, report["recordings"].back()["files"]); !done)
      return tl::unexpected(done.error());
    if (path == options.recordings.front())
      if (auto done =
              measure_file(*motion, long_bound, options.long_frames, options, report["long"]);
          !done)
        return tl::unexpected(done.error());
  }
  return Findings{std::move(report), code};
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::benchmark_main<ribbon::Options>("benchmark_recording", argc, argv,
                                                 ribbon::describe, ribbon::run);
}
