#include "converter/excerpt.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "commandline/progress.h"
#include "files/files.h"
#include "files/part_file.h"
#include "geometry/single_precision.h"
#include "recording/writer/record_file.h"
#include "recording/writer/recording_writer.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// Of the distance between two points whose coordinates each move by so much.
double largest_change_m(double coordinate_error_m) {
  return 2 * std::sqrt(3.0) * (1 + 1e-12) * coordinate_error_m;
}

// From each of `kept` to the next; 1 where that is not the same everywhere.
int even_stride(const std::vector<int>& kept) {
  if (kept.size() < 2) return 1;
  const int stride = kept[1] - kept[0];
  for (std::size_t i = 1; i < kept.size(); ++i)
    if (kept[i] - kept[i - 1] != stride) return 1;
  return stride;
}

// Of single precision, which alone has moved the coordinates of a recording without loss.
double rounding_m(float reach_m) {
  return 0.5 * last_place(reach_m);
}

Result<void> coarsen(RecordingHeader& header, double max_error_m, float reach_m) {
  const double error_m =
      header.max_position_error_m > 0 ? header.max_position_error_m : rounding_m(reach_m);
  const double added_m = max_error_m - error_m;
  if (added_m <= 0)
    return failure("",
                   "its positions are within " + metres(error_m, Rounding::up) +
                       " of the truth, so they cannot come to be within " + metres(max_error_m),
                   "leave --max-error out, or choose more");
  const double change_m = largest_change_m(added_m);
  if (header.stated_gap_m > 0 && change_m >= header.stated_gap_m) {
    constexpr double told = 1.01;  // of what is told in three digits
    const double most_m = error_m + header.stated_gap_m / largest_change_m(1);
    return failure("", "layers could meet that it keeps " + metres(header.stated_gap_m) + " apart",
                   most_m > told * std::max(error_m, ConversionRequest::least_max_error_m)
                       ? "choose less than " + metres(most_m, Rounding::down) + " for --max-error"
                       : "leave --max-error out");
  }
  header.stated_gap_m -= std::min(change_m, header.stated_gap_m);
  if (header.strain_limit > 0)
    header.strain_limit += change_m / rest_size(header).shortest_edge_m();
  header.max_position_error_m = max_error_m;
  header.quantisation_step_m = quantisation_step_m(added_m, reach_m);
  return {};
}

// The largest coordinate, in magnitude.
Result<float> reach_of(const ConversionRequest& request, ConversionJob& job) {
  float reach_m = 0;
  Eigen::Matrix3Xf positions;
  for (const int index : job.frames) {
    if (request.interrupted()) return interrupted_conversion();
    if (job.reader.read(index, positions))
      reach_m = std::max(reach_m, positions.cwiseAbs().maxCoeff());
  }
  return reach_m;
}

// The older recording, locked, so that nobody writes it or goes on with it; nothing where none is.
Result<std::optional<RecordFile>> locked_older(const std::filesystem::path& output) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(output, code)) return std::nullopt;
  return RecordFile::open(output).map(
      [](RecordFile&& file) { return std::optional(std::move(file)); });
}

// What is told of a part that is thrown away, as of the output. What the writer calls safe goes
// with the part.
Error of_output(Error error, const std::string& part, const std::string& output) {
  if (!error.place.starts_with(part)) return error;
  if (error.place == part)
    error.remedy = error.may_pass ? "free some space and convert again" : "choose another place";
  error.place.replace(0, part.size(), output);
  return error;
}

class Excerpt {
 public:
  Excerpt(RecordingReader& reader, RecordingWriter& writer, bool same_step)
      : reader_(reader), writer_(writer), same_step_(same_step) {}

  // False where the recording has lost the frame.
  Result<bool> take(int index) {
    const auto numbers = reader_.numbers(index);
    if (!numbers || !reader_.readable(index)) return false;
    return same_step_ ? take_as_it_is(index, *numbers) : take_rounded(index, *numbers);
  }

 private:
  Result<bool> take_as_it_is(int index, const FrameNumbers& numbers) {
    const auto quantised = reader_.read_quantised(index);
    if (!quantised) return false;
    return writer_.append(numbers, **quantised).map([] { return true; });
  }

  Result<bool> take_rounded(int index, const FrameNumbers& numbers) {
    Eigen::Matrix3Xf positions;
    if (!reader_.read(index, positions)) return false;
    return writer_.append(numbers, positions.cast<double>()).map([] { return true; });
  }

  RecordingReader& reader_;
  RecordingWriter& writer_;
  bool same_step_;
};

// With what ended the run, where the last frame is kept; one that has no end gets none here either.
Result<void> finish(RecordingWriter& writer, const RecordingReader& reader, int last_kept) {
  if (last_kept + 1 != reader.frame_count()) return writer.finish(RunEnding::unknown);
  return reader.finished() ? writer.finish(reader.ending()) : writer.sync();
}

Result<ConversionReport> copy_frames(const ConversionRequest& request, ConversionJob& job,
                                     RecordingWriter& writer) {
  Excerpt excerpt(job.reader, writer, request.max_error_m == 0);
  ProgressLine progress("frame", static_cast<int>(job.frames.size()), request.progress);
  ConversionReport report;
  std::optional<int> last_kept;
  for (const int index : job.frames) {
    if (request.interrupted()) return interrupted_conversion();
    const Result<bool> taken = excerpt.take(index);
    if (!taken) return tl::unexpected(taken.error());
    if (*taken) {
      if (last_kept) report.left_out = std::max(report.left_out, index - *last_kept - 1);
      last_kept = index;
      ++report.frames_written;
    } else {
      report.missing.push_back(index + 1);
    }
    progress.update(report.frames_written + static_cast<int>(report.missing.size()));
  }
  if (!last_kept) return failure("", "none of the frames can be read", "record it again");
  return finish(writer, job.reader, *last_kept).map([&] {
    report.bytes_written = writer.bytes_written();
    report.damage = job.reader.damage();
    report.first_file = report.last_file = request.output;
    return report;
  });
}

}  // namespace

Result<RecordingHeader> excerpt_header(const RecordingHeader& source, const std::vector<int>& kept,
                                       double max_error_m, float reach_m) {
  RecordingHeader header = source;
  header.writer = std::string("ribbon-convert ") + RIBBON_VERSION;
  header.frames_per_second = source.frames_per_second / even_stride(kept);
  if (max_error_m > 0)
    if (auto coarsened = coarsen(header, max_error_m, reach_m); !coarsened)
      return tl::unexpected(coarsened.error());
  return header;
}

Result<ConversionReport> write_excerpt(const ConversionRequest& request, ConversionJob job) {
  if (!std::is_sorted(job.frames.begin(), job.frames.end()))
    return failure("", "a recording runs forwards", "give --frames a positive step");
  const Result<float> reach_m = request.max_error_m > 0 ? reach_of(request, job) : Result<float>(0);
  if (!reach_m) return tl::unexpected(reach_m.error());
  const auto header =
      excerpt_header(job.reader.header(), job.frames, request.max_error_m, *reach_m);
  if (!header)
    return failure(request.recording.string(), header.error().problem, header.error().remedy);
  const auto older = locked_older(request.output);
  if (!older) return tl::unexpected(older.error());
  auto part = PartFile::create(request.output);
  if (!part) return tl::unexpected(part.error());
  return RecordingWriter::create(part->path(), *header)
      .and_then([&](RecordingWriter writer) { return copy_frames(request, job, writer); })
      .map_error([&](Error error) {
        return of_output(std::move(error), part->path().string(), request.output);
      })
      .and_then([&](ConversionReport report) {
        return part->take_place_of(request.output, request.later()).map([&] {
          sync_folder_of(request.output);
          return report;
        });
      });
}

}  // namespace ribbon
