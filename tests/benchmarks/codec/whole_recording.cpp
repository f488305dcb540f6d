#include "benchmarks/codec/whole_recording.h"

#include <algorithm>
#include <random>

#include "benchmarks/codec/codec_measurement.h"
#include "playback/recording_reader.h"
#include "recording/codec/codec_parameters.h"
#include "recording/writer/recording_writer.h"

namespace ribbon {

namespace {

constexpr int openings = 15;
constexpr int jumps = 1000;

// Value `share` of the way from the smallest to the largest.
double quantile(std::vector<double> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// 0, 1, ..., last, last - 1, ..., 0, 1, ...
std::size_t to_and_fro(int frame, std::size_t count) {
  if (count < 2) return 0;
  const std::size_t at = frame % (2 * (count - 1));
  return std::min(at, 2 * (count - 1) - at);
}

Result<void> record(const RecordedMotion& motion, double bound_m, int frames,
                    const std::filesystem::path& path) {
  RecordingHeader header = motion.header;
  header.max_position_error_m = bound_m;
  header.quantisation_step_m = motion.quantisation_step_m(bound_m);
  auto writer = RecordingWriter::create(path, header);
  if (!writer) return tl::unexpected(writer.error());
  for (int frame = 0; frame < frames; ++frame) {
    const std::size_t at = to_and_fro(frame, motion.frames.size());
    FrameNumbers numbers = motion.numbers[at];
    numbers.time_s = frame / header.frames_per_second;
    if (auto done = writer->append(numbers, motion.frames[at].cast<double>()); !done) return done;
  }
  return writer->finish(RunEnding::duration);
}

Result<double> open_s(const std::filesystem::path& path) {
  std::vector<double> took_s;
  for (int i = 0; i < openings; ++i) {
    const double begun_s = thread_s();
    const auto reader = RecordingReader::open(path);
    took_s.push_back(thread_s() - begun_s);
    if (!reader) return tl::unexpected(reader.error());
  }
  return quantile(took_s, 0.5);
}

Result<std::vector<double>> jump(RecordingReader& reader) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> any_frame(0, reader.frame_count() - 1);
  Eigen::Matrix3Xf positions;
  std::vector<double> took_s;
  for (int i = 0; i < jumps; ++i) {
    const int frame = any_frame(random);
    const double begun_s = thread_s();
    const auto read = reader.read(frame, positions);
    took_s.push_back(thread_s() - begun_s);
    if (!read) return tl::unexpected(read.error());
  }
  return took_s;
}

}  // namespace

Result<FileFigures> measure_file(const RecordedMotion& motion, double bound_m, int frames,
                                 const std::filesystem::path& path) {
  if (auto recorded = record(motion, bound_m, frames, path); !recorded)
    return tl::unexpected(recorded.error());
  const auto opened_s = open_s(path);
  if (!opened_s) return tl::unexpected(opened_s.error());
  auto reader = RecordingReader::open(path);
  if (!reader) return tl::unexpected(reader.error());
  const auto jumps_s = jump(*reader);
  if (!jumps_s) return tl::unexpected(jumps_s.error());
  const double particle_frames = static_cast<double>(motion.frames.front().cols()) * frames;
  return FileFigures{frames, 8 * static_cast<double>(reader->file_bytes()) / particle_frames,
                     *opened_s, quantile(*jumps_s, 0.5), quantile(*jumps_s, 0.99)};
}

}  // namespace ribbon
