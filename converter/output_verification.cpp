#include "converter/output_verification.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <utility>

#include "commandline/extension.h"
#include "commandline/progress.h"
#include "converter/conversion_job.h"
#include "converter/motion_format.h"
#include "converter/read_back/read_back.h"
#include "converter/reader_pool.h"
#include "converter/sequence_names.h"
#include "parallel/parallel.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr std::size_t frames_at_a_time = 8;  // as they are written

// Displacements since the first frame, which may be twice as large as coordinates, are rounded to
// half a digit: in .glb of single precision, in .fbx of double.
double rounding_of(const std::string& extension) {
  if (extension == ".glb") return 1.01 * 0x1p-23;
  return extension == ".fbx" ? 1.01 * 0x1p-52 : 0;
}

ComparisonSettings settings_for(const std::string& extension, std::optional<double> tolerance_m) {
  return {.tolerance_m = tolerance_m, .format_rounding = rounding_of(extension)};
}

tl::unexpected<Error> interrupted() {
  return passing_failure("", "interrupted while reading back", "repeat it with --verify-only");
}

// Of which files and readers is said later.
VerificationReport report_of(const Comparison& comparison, const std::vector<Damage>& damage) {
  VerificationReport report;
  report.deviations = comparison.deviations();
  report.damage = damage;
  return report;
}

// What is done with a file that can be opened; that it cannot, or turns out to be spoiled, is a
// difference.
template <class Use>
void with_file(const FileReader& reader, const std::filesystem::path& path, Comparison& comparison,
               const Use& use) {
  const auto used = read_strictly(path, [&] {
    const auto file = reader.read(path);
    use(*file);
    return true;
  });
  if (!used) comparison.see_difference(used.error().sentence());
}

// Expects the ribbon of a frame. False where the recording has lost it, which is noted, or it
// cannot be made a solid: it was not written, and a motion holds the one before it.
bool expect_frame(RecordingReader& reader, int index, Comparison& comparison) {
  Eigen::Matrix3Xf positions;
  if (reader.readable(index) && reader.read(index, positions))
    return comparison.expect_ribbon(index + 1, positions);
  comparison.see_lost(index + 1);
  return false;
}

// A motion begins with the first frame that can be written.
Result<void> expect_first_frame(const ConversionRequest& request, ConversionJob& job,
                                Comparison& comparison) {
  for (const int index : job.frames) {
    if (request.interrupted()) return interrupted();
    if (expect_frame(job.reader, index, comparison)) return {};
  }
  return no_frames(job.model, comparison.deviations().missing.size() < job.frames.size());
}

// The base mesh that positions in a point cache are for.
void verify_base(const ConversionRequest& request, Comparison& comparison) {
  const auto base = std::filesystem::path(request.output).replace_extension(".obj");
  with_file(*file_reader(".obj"), base, comparison, [&](WrittenMotion& file) {
    comparison.see_scene(file.scene(), 1, base.string());
    comparison.see_ribbon(file.ribbon(0));
  });
}

Result<void> verify_frames(const ConversionRequest& request, ConversionJob& job,
                           WrittenMotion& file, Comparison& comparison) {
  const int frames = static_cast<int>(job.frames.size());
  comparison.see_scene(file.scene(), frames, request.output);
  ProgressLine progress("frame", frames, request.progress);
  for (int i = 0; i < std::min(frames, file.scene().frames); ++i) {
    if (request.interrupted()) return interrupted();
    (void)expect_frame(job.reader, job.frames[static_cast<std::size_t>(i)], comparison);
    comparison.see_ribbon(file.ribbon(i));
    progress.update(i + 1);
  }
  return {};
}

Result<VerificationReport> verify_motion(const ConversionRequest& request, ConversionJob& job,
                                         const FileReader& reader,
                                         const ComparisonSettings& settings) {
  Comparison comparison(job.model, job.reader.header(), settings);
  if (auto expected = expect_first_frame(request, job, comparison); !expected)
    return tl::unexpected(expected.error());
  if (motion_format(request.output)->deforms_base) {
    Comparison base = comparison;
    verify_base(request, base);
    if (!base.deviations().good()) return report_of(base, job.reader.damage());
  }
  Result<void> verified;
  with_file(reader, request.output, comparison,
            [&](WrittenMotion& file) { verified = verify_frames(request, job, file, comparison); });
  return verified.map([&] { return report_of(comparison, job.reader.damage()); });
}

// The obstacle alone.
VerificationReport verify_still_life(const ConversionRequest& request, const ConversionJob& job,
                                     const FileReader& reader, const ComparisonSettings& settings) {
  Comparison comparison(job.model, job.reader.header(), settings);
  with_file(reader, request.output, comparison,
            [&](WrittenMotion& file) { comparison.see_scene(file.scene(), 1, request.output); });
  return report_of(comparison, {});
}

// One file a frame, on all cores.
class SequenceVerification {
 public:
  SequenceVerification(const ConversionRequest& request, ConversionJob job, SequenceNames names,
                       const FileReader& reader, ComparisonSettings settings)
      : request_(request),
        names_(std::move(names)),
        reader_(reader),
        settings_(settings),
        model_(std::move(job.model)),
        frames_(std::move(job.frames)),
        recordings_(request.recording, std::move(job.reader)),
        progress_("frame", static_cast<int>(frames_.size()), request.progress) {}

  Result<VerificationReport> verify() {
    parallel_ranges(frames_.size(), frames_at_a_time,
                    [this](std::size_t begin, std::size_t end) { verify_range(begin, end); });
    if (failure_) return tl::unexpected(*failure_);
    VerificationReport report;
    report.damage = recordings_.damage();
    for (const auto& [begin, found] : found_) report.deviations.add(found);
    if (!expected_) return no_frames(model_, report.deviations.missing.size() < frames_.size());
    return report;
  }

 private:
  void verify_range(std::size_t begin, std::size_t end) {
    auto recording = recordings_.take();
    if (!recording) return stop(recording.error());
    Comparison comparison(model_, recording->header(), settings_);
    for (std::size_t slot = begin; slot < end && !stopped_; ++slot)
      verify_frame(*recording, slot, comparison);
    recordings_.give_back(std::move(*recording));
    const std::lock_guard lock(mutex_);
    found_[begin] = comparison.deviations();
  }

  void verify_frame(RecordingReader& recording, std::size_t slot, Comparison& comparison) {
    if (request_.interrupted()) return stop(interrupted().value());
    const std::filesystem::path path = names_.frame(slot);
    if (expect_frame(recording, frames_[slot], comparison)) {
      expected_ = true;
      with_file(reader_, path, comparison, [&](WrittenMotion& file) {
        comparison.see_scene(file.scene(), 1, path.string());
        comparison.see_ribbon(file.ribbon(0));
      });
    }
    const std::lock_guard lock(mutex_);
    progress_.update(++done_);
  }

  void stop(const Error& error) {
    const std::lock_guard lock(mutex_);
    failure_ = error;
    stopped_ = true;
  }

  const ConversionRequest& request_;
  SequenceNames names_;
  const FileReader& reader_;
  ComparisonSettings settings_;
  Model model_;
  std::vector<int> frames_;
  ReaderPool recordings_;
  std::mutex mutex_;  // guards what follows
  ProgressLine progress_;
  int done_ = 0;
  std::map<std::size_t, Deviations> found_;  // of each range, in the order of frames
  std::optional<Error> failure_;
  std::atomic<bool> expected_ = false;  // any frame
  std::atomic<bool> stopped_ = false;
};

Result<VerificationReport> verify_job(const ConversionRequest& request, ConversionJob job,
                                      const FileReader& reader,
                                      const ComparisonSettings& settings) {
  if (!request.model.with_ribbon) return verify_still_life(request, job, reader, settings);
  if (job.format == OutputFormat::whole_motion)
    return verify_motion(request, job, reader, settings);
  auto names = SequenceNames::of(request, job.frames);
  if (!names) return tl::unexpected(names.error());
  return SequenceVerification(request, std::move(job), std::move(*names), reader, settings)
      .verify();
}

}  // namespace

Result<void> check_verifiable(const ConversionRequest& request) {
  const std::string extension = lower_case_extension(request.output);
  if (extension == ".rbn")
    return failure(request.output, "is a recording, which ribbon-play --verify proves",
                   "leave --verify out");
  if (extension == ".csv")
    return failure(request.output, "holds no positions that could be compared",
                   "leave --verify out");
  return {};
}

Result<VerificationReport> verify_output(const ConversionRequest& request,
                                         std::optional<double> tolerance_m) {
  if (auto verifiable = check_verifiable(request); !verifiable)
    return tl::unexpected(verifiable.error());
  auto job = open_job(request);
  if (!job) return tl::unexpected(job.error());
  const std::string extension = lower_case_extension(request.output);
  const FileReader& reader = *file_reader(extension);
  return verify_job(request, std::move(*job), reader, settings_for(extension, tolerance_m))
      .map([&](VerificationReport report) {
        report.extension = extension;
        report.reader = reader.name;
        return report;
      });
}

std::string verification_text(const VerificationReport& report) {
  const Deviations& found = report.deviations;
  if (!found.difference.empty()) return found.difference;
  const std::string head = filled_in("{} as {} reads it, {} {}: ", report.extension, report.reader,
                                     found.frames, found.frames == 1 ? "frame" : "frames");
  if (found.largest_m == 0) return head + "exactly as recorded";
  const std::string place = found.frame > 0 ? filled_in("frame {}", found.frame) : "the obstacle";
  return head + (found.within ? "at most " : "") + metres(found.largest_m, Rounding::up) +
         " from the recording, in " + place + "; " + (found.within ? "up to " : "only ") +
         metres(found.allowed_m, Rounding::up) + " is allowed";
}

}  // namespace ribbon
