#include "benchmarks/codec/codec_measurement.h"

#include <algorithm>
#include <ctime>
#include <limits>

namespace ribbon {

namespace {

// A quick codec is run until it has had this long with each group, a slow one once.
constexpr double enough_s = 0.012;
constexpr int most_runs = 7;

// What is summed up over groups.
struct Sums {
  double bytes = 0;
  double frames = 0;
  double encode_s = 0;
  double decode_s = 0;
  double worst_error_m = 0;
};

// Seconds of the quickest run.
template <class Run>
double quickest_s(int runs, const Run& run) {
  double best_s = std::numeric_limits<double>::infinity();
  double all_s = 0;
  for (int i = 0; i < runs && all_s < enough_s; ++i) {
    const double begun_s = thread_s();
    run();
    const double took_s = thread_s() - begun_s;
    best_s = std::min(best_s, took_s);
    all_s += took_s;
  }
  return best_s;
}

double worst_error_m(const FrameCodec& codec, FrameSpan frames) {
  double worst_m = 0;
  for (std::size_t i = 0; i < frames.size(); ++i)
    worst_m = std::max(
        worst_m, (codec.decoded(static_cast<int>(i)).cast<double>() - frames[i].cast<double>())
                     .cwiseAbs()
                     .maxCoeff());
  return worst_m;
}

void add_group(FrameCodec& codec, FrameSpan frames, int runs, Sums& sums) {
  codec.take(frames);
  std::size_t bytes = 0;
  sums.encode_s += quickest_s(runs, [&] { bytes = codec.encode(); });
  sums.decode_s += quickest_s(runs, [&] { codec.decode(); });
  sums.bytes += static_cast<double>(bytes);
  sums.frames += static_cast<double>(frames.size());
  sums.worst_error_m = std::max(sums.worst_error_m, worst_error_m(codec, frames));
}

void add_block(FrameCodec& codec, FrameSpan block, int group_frames, int runs, Sums& sums) {
  const std::size_t most = group_frames;
  for (std::size_t at = 0; at < block.size(); at += most)
    add_group(codec, block.subspan(at, std::min(most, block.size() - at)), runs, sums);
}

Sums sums_of(FrameCodec& codec, const std::vector<FrameSpan>& blocks, int group_frames, int runs) {
  Sums sums;
  for (const FrameSpan block : blocks) add_block(codec, block, group_frames, runs, sums);
  return sums;
}

CodecFigures figures_of(const Sums& sums, int particles) {
  const double gigabytes = 12e-9 * particles * sums.frames;
  return {8 * sums.bytes / (particles * sums.frames), gigabytes / sums.encode_s,
          gigabytes / sums.decode_s, sums.worst_error_m};
}

// A first look, at a group in the middle: settings that keep the bound there, the smallest first.
std::vector<const CodecRow::Make*> ranked_settings(const CodecRow& row, const CodecTask& task,
                                                   const std::vector<FrameSpan>& blocks) {
  const FrameSpan middle = blocks[blocks.size() / 2];
  const FrameSpan group =
      middle.first(std::min(middle.size(), static_cast<std::size_t>(row.group_frames)));
  std::vector<std::pair<double, const CodecRow::Make*>> ranked;
  for (const CodecRow::Make& make : row.settings) {
    const auto codec = make(task);
    if (!codec) continue;
    const Sums sums = sums_of(*codec, {group}, row.group_frames, 1);
    if (sums.worst_error_m <= task.bound_m) ranked.emplace_back(sums.bytes, &make);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const CodecRow::Make*> settings;
  settings.reserve(ranked.size());
  for (const auto& [bytes, make] : ranked) settings.push_back(make);
  return settings;
}

}  // namespace

double thread_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::optional<CodecFigures> measure(const CodecRow& row, const CodecTask& task,
                                    const std::vector<FrameSpan>& blocks) {
  for (const CodecRow::Make* make : ranked_settings(row, task, blocks)) {
    const Sums sums = sums_of(*(*make)(task), blocks, row.group_frames, most_runs);
    if (sums.worst_error_m <= task.bound_m) return figures_of(sums, task.grid.particle_count());
  }
  return std::nullopt;
}

}  // namespace ribbon
