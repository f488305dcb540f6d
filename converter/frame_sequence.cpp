#include "converter/frame_sequence.h"

#include <atomic>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "commandline/frame_pattern.h"
#include "commandline/progress.h"
#include "converter/export/fbx_export.h"
#include "converter/export/obj_text.h"
#include "converter/output_names.h"
#include "converter/reader_pool.h"
#include "files/files.h"
#include "parallel/parallel.h"

namespace ribbon {

namespace {

constexpr std::size_t frames_per_range = 8;  // consecutive, because a reader likes ascending order

// What became of one frame; all empty: it was not tried, because another one failed.
struct Outcome {
  std::uint64_t bytes = 0;
  bool lost = false;  // by damage to the recording
  std::optional<Error> failure;
};

class Sequence {
 public:
  Sequence(const ConversionRequest& request, OutputFormat format, RecordingReader reader,
           const Model& model, const std::vector<int>& frames, FramePattern file)
      : format_(format),
        interrupted_(request.interrupted),
        material_library_(material_library_name(request.output)),
        model_(model),
        frames_(frames),
        file_(std::move(file)),
        readers_(request.recording, std::move(reader)),
        progress_("frame", static_cast<int>(frames.size()), request.quiet),
        outcomes_(frames.size()) {}

  Result<ConversionReport> write() {
    if (format_ == OutputFormat::obj)
      if (auto written = write_material_library(); !written) return tl::unexpected(written.error());
    parallel_ranges(frames_.size(), frames_per_range,
                    [this](std::size_t begin, std::size_t end) { write_range(begin, end); });
    progress_.clear();
    return report();
  }

 private:
  // Into every folder that gets frames, since {frame} may stand in a folder's name.
  Result<void> write_material_library() {
    std::set<std::filesystem::path> folders;
    for (const int index : frames_) folders.insert(file_.file(index + 1).parent_path());
    for (const auto& folder : folders)
      if (auto written = write_file(folder / material_library_, material_library_text(model_));
          !written)
        return written;
    return {};
  }

  void write_range(std::size_t begin, std::size_t end) {
    if (stopped_) return;
    Result<RecordingReader> reader = readers_.take();
    if (!reader) return stop(outcomes_[begin], reader.error());
    Model model = model_;
    for (std::size_t slot = begin; slot < end && !stopped_; ++slot) {
      write_frame(*reader, model, frames_[slot], outcomes_[slot]);
      count_done();
    }
    readers_.give_back(std::move(*reader));
  }

  void write_frame(RecordingReader& reader, Model& model, int index, Outcome& outcome) {
    if (interrupted_()) return stop(outcome, {"", "interrupted", "what is written is complete"});
    Eigen::Matrix3Xf positions;
    outcome.lost = !reader.readable(index) || !reader.read(index, positions);
    if (outcome.lost) return;
    const Result<std::string> bytes =
        pose_ribbon(model, positions, index + 1).and_then([&] { return encode(model); });
    if (!bytes) return stop(outcome, bytes.error());
    const Result<void> written = write_file(file_.file(index + 1), *bytes);
    if (!written) return stop(outcome, written.error());
    outcome.bytes = bytes->size();
  }

  [[nodiscard]] Result<std::string> encode(const Model& model) const {
    if (format_ == OutputFormat::fbx) return fbx_bytes(model);
    return obj_text(model, material_library_);
  }

  void stop(Outcome& outcome, const Error& error) {
    outcome.failure = error;
    stopped_ = true;
  }

  void count_done() {
    const std::lock_guard lock(progress_mutex_);
    progress_.update(++done_);
  }

  [[nodiscard]] Result<ConversionReport> report() {
    ConversionReport report;
    report.damage = readers_.damage();
    report.first_file = file_.file(frames_.front() + 1);
    report.last_file = file_.file(frames_.back() + 1);
    for (std::size_t slot = 0; slot < frames_.size(); ++slot) {
      const Outcome& outcome = outcomes_[slot];
      if (outcome.failure) return tl::unexpected(*outcome.failure);
      if (outcome.lost) report.missing.push_back(frames_[slot] + 1);
      report.frames_written += outcome.lost ? 0 : 1;
      report.bytes_written += outcome.bytes;
    }
    if (report.frames_written == 0)
      return failure("", "none of the frames can be read", "record it again");
    return report;
  }

  OutputFormat format_;
  std::function<bool()> interrupted_;
  std::string material_library_;
  const Model& model_;
  const std::vector<int>& frames_;
  FramePattern file_;
  ReaderPool readers_;
  std::mutex progress_mutex_;
  ProgressLine progress_;
  int done_ = 0;
  std::vector<Outcome> outcomes_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace

Result<ConversionReport> write_frame_sequence(const ConversionRequest& request, OutputFormat format,
                                              RecordingReader reader, const Model& model,
                                              const std::vector<int>& frames) {
  auto file = FramePattern::parse(request.output, static_cast<int>(frames.size()));
  if (!file) return tl::unexpected(file.error());
  return Sequence(request, format, std::move(reader), model, frames, std::move(*file)).write();
}

}  // namespace ribbon
