#include "converter/expected_size.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <numeric>
#include <system_error>
#include <utility>
#include <vector>

#include "converter/encode_model.h"
#include "converter/excerpt.h"
#include "converter/motion_format.h"
#include "converter/number_table.h"
#include "files/part_file.h"
#include "model/obj_text.h"

namespace ribbon {

namespace {

constexpr std::size_t most_samples = 6;

// The first frame, and those in the middle of equal parts of all.
std::vector<int> samples_of(const std::vector<int>& frames) {
  const std::size_t parts = std::min(frames.size() - 1, most_samples);
  std::vector<int> samples{frames.front()};
  for (std::size_t part = 0; part < parts; ++part)
    samples.push_back(frames[1 + (2 * part + 1) * (frames.size() - 1) / (2 * parts)]);
  return samples;
}

double processor_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// What was spent on some frames.
class TimeSpent {
 public:
  template <class Work>
  auto on(const Work& work) {
    const double start_s = processor_s();
    auto answer = work();
    seconds_ += processor_s() - start_s;
    ++frames_;
    return answer;
  }
  [[nodiscard]] double a_frame_s() const { return frames_ == 0 ? 0 : seconds_ / frames_; }

 private:
  double seconds_ = 0;
  int frames_ = 0;
};

// The model in the pose of each sample. One that cannot be written holds the pose before it or, at
// the start, after it, as a motion does; if need be, that of a frame which is no sample.
Result<std::vector<Model>> posed_at(const ConversionRequest& request, ConversionJob& job,
                                    const std::vector<int>& samples, TimeSpent& reading) {
  std::vector<int> candidates = samples;
  candidates.insert(candidates.end(), job.frames.begin(), job.frames.end());
  std::vector<Model> poses;
  bool some_refused = false;
  Model model = job.model;
  Eigen::Matrix3Xf positions;
  for (std::size_t i = 0; i < samples.size() || (i < candidates.size() && poses.empty()); ++i) {
    if (request.interrupted()) return interrupted_conversion();
    const int index = candidates[i];
    // Only the frame before it makes a frame as quick to read as those in a row are.
    if (index > 0 && job.reader.readable(index - 1)) (void)job.reader.read(index - 1, positions);
    Result<bool> posed = false;
    if (job.reader.readable(index)) {
      posed = reading.on([&] {
        return job.reader.read(index, positions) ? pose_ribbon(model, positions, index + 1)
                                                 : Result<bool>(false);
      });
      if (!posed) return tl::unexpected(posed.error());
      some_refused |= !*posed && job.reader.readable(index);
    }
    if (*posed || !poses.empty()) poses.push_back(model);
  }
  if (poses.empty()) return no_frames(job.model, some_refused);
  const Model first = poses.front();
  poses.insert(poses.begin(), samples.size() - poses.size(), first);
  return poses;
}

// `frames` files or parts of a file, of about the sizes that were found.
ExpectedSize size_of(double frames, const std::vector<double>& found) {
  if (found.empty()) return {};
  const auto [least, most] = std::minmax_element(found.begin(), found.end());
  const double mean =
      std::accumulate(found.begin(), found.end(), 0.0) / static_cast<double>(found.size());
  return {.bytes = frames * mean, .margin_bytes = frames * (*most - *least) / 2};
}

// In the temporary folder; goes again.
Result<PartFile> trial_file() {
  std::error_code code;
  const auto folder = std::filesystem::temp_directory_path(code);
  if (code)
    return failure("the temporary folder", "cannot be used (" + code.message() + ")",
                   "name another one in the environment variable TMPDIR");
  return PartFile::create(folder / "ribbon-convert-dry-run");
}

Result<double> motion_bytes(const MotionFormat& format, const std::vector<Model>& poses,
                            TimeSpent& writing) {
  const auto part = trial_file();
  if (!part) return tl::unexpected(part.error());
  const auto writer =
      format.new_writer(part->path(), poses.front(), static_cast<int>(poses.size()));
  if (!writer) return tl::unexpected(writer.error());
  for (const Model& pose : poses)
    if (auto appended = writing.on([&] { return (*writer)->append(pose); }); !appended)
      return tl::unexpected(appended.error());
  return (*writer)->finish().map(
      [&] { return static_cast<double>(std::filesystem::file_size(part->path())); });
}

// What a frame adds is how much longer a file is of three frames than of the two others: the second
// one brings along what is there once for all that moves.
Result<double> added_bytes(const MotionFormat& format, const Model& first, const Model& other,
                           const Model& pose, TimeSpent& writing) {
  auto without = motion_bytes(format, {first, other}, writing);
  if (!without) return without;
  return motion_bytes(format, {first, other, pose}, writing).map([&](double with) {
    return with - *without;
  });
}

Result<ExpectedSize> size_of_motion(const MotionFormat& format, const std::vector<Model>& poses,
                                    std::size_t frames, TimeSpent& writing) {
  const std::vector<Model> begin(poses.begin(), poses.begin() + (poses.size() > 1 ? 2 : 1));
  const auto begin_bytes = motion_bytes(format, begin, writing);
  if (!begin_bytes) return tl::unexpected(begin_bytes.error());
  std::vector<double> added;
  for (std::size_t i = 1; i < poses.size() && poses.size() > 2; ++i) {
    const auto bytes = added_bytes(format, poses[0], poses[i == 1 ? 2 : 1], poses[i], writing);
    if (!bytes) return tl::unexpected(bytes.error());
    added.push_back(*bytes);
  }
  ExpectedSize size = size_of(static_cast<double>(frames - begin.size()), added);
  size.bytes += *begin_bytes;
  if (format.deforms_base)
    size.bytes += static_cast<double>(obj_text(poses.front(), "name.mtl").size());
  return size;
}

Result<ExpectedSize> size_of_sequence(OutputFormat format, const std::vector<Model>& poses,
                                      std::size_t frames, TimeSpent& writing) {
  std::vector<double> found;
  for (const Model& pose : poses) {
    const auto bytes = writing.on([&] { return encode_model(format, pose, "name.mtl"); });
    if (!bytes) return tl::unexpected(bytes.error());
    found.push_back(static_cast<double>(bytes->size()));
  }
  return size_of(static_cast<double>(frames), found);
}

ExpectedSize size_of_table(const ConversionJob& job, const std::vector<int>& samples) {
  std::vector<double> found(samples.size());
  std::transform(samples.begin(), samples.end(), found.begin(), [&](int index) {
    return static_cast<double>(number_table_line(job.reader, index).size());
  });
  ExpectedSize size = size_of(static_cast<double>(job.frames.size()), found);
  size.bytes += static_cast<double>(number_table_title(job.reader.header()).size());
  return size;
}

// Of an excerpt that is really written.
Result<double> excerpt_bytes(ConversionRequest request, const std::vector<int>& frames) {
  auto job = open_job(request);
  if (!job) return tl::unexpected(job.error());
  job->frames = frames;
  const auto part = trial_file();
  if (!part) return tl::unexpected(part.error());
  request.output = part->path();
  request.force = true;  // that file is there
  request.progress = ProgressStyle::none;
  return write_excerpt(request, std::move(*job)).map([](const ConversionReport& report) {
    return static_cast<double>(report.bytes_written);
  });
}

// Frames are predicted from each other, so that some in a row are tried: at the beginning, in the
// middle and at the end.
Result<ExpectedSize> size_of_excerpt(const ConversionRequest& request, ConversionJob& job) {
  constexpr std::size_t in_a_row = 25;
  job.reader.check();
  std::vector<int> frames = job.frames;
  std::erase_if(frames, [&](int index) { return !job.reader.readable(index); });
  if (frames.empty()) return no_frames(job.model, false);
  const auto head = excerpt_bytes(request, {frames.front()});
  if (!head || frames.size() == 1)
    return head.map([](double bytes) { return ExpectedSize{.bytes = bytes}; });
  const std::size_t length = std::min(in_a_row, frames.size());
  std::vector<double> found;
  for (const std::size_t begin :
       {std::size_t{0}, (frames.size() - length) / 2, frames.size() - length}) {
    const auto first = frames.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto bytes = excerpt_bytes(request, {first, first + static_cast<std::ptrdiff_t>(length)});
    if (!bytes) return tl::unexpected(bytes.error());
    found.push_back((*bytes - *head) / static_cast<double>(length - 1));
  }
  ExpectedSize size = size_of(static_cast<double>(frames.size() - 1), found);
  size.bytes += *head;
  return size;
}

Result<ExpectedSize> size_of_ribbon(const ConversionRequest& request, ConversionJob& job,
                                    const std::vector<int>& samples) {
  TimeSpent reading;
  TimeSpent writing;
  const auto poses = posed_at(request, job, samples, reading);
  if (!poses) return tl::unexpected(poses.error());
  const std::size_t frames = job.frames.size();
  auto size = job.format == OutputFormat::whole_motion
                  ? size_of_motion(*motion_format(request.output), *poses, frames, writing)
                  : size_of_sequence(job.format, *poses, frames, writing);
  if (size)
    size->processor_s = static_cast<double>(frames) * (reading.a_frame_s() + writing.a_frame_s());
  return size;
}

}  // namespace

Result<ExpectedSize> expected_size(const ConversionRequest& request, ConversionJob& job) {
  const std::vector<int> samples = samples_of(job.frames);
  if (job.format == OutputFormat::recording) return size_of_excerpt(request, job);
  if (job.format == OutputFormat::numbers) return size_of_table(job, samples);
  if (request.model.with_ribbon) return size_of_ribbon(request, job, samples);
  TimeSpent writing;
  return size_of_sequence(job.format, {job.model}, 1, writing);
}

}  // namespace ribbon
