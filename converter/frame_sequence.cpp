#include "converter/frame_sequence.h"

#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

#include "commandline/progress.h"
#include "converter/companions.h"
#include "converter/encode_model.h"
#include "converter/reader_pool.h"
#include "converter/sequence_log.h"
#include "converter/sequence_names.h"
#include "files/files.h"
#include "files/part_file.h"
#include "parallel/parallel.h"

namespace ribbon {

namespace {

constexpr std::size_t frames_per_range = 8;  // consecutive, because a reader likes ascending order

// What became of one frame; all empty: it was not tried, because another one failed.
struct Outcome {
  std::uint64_t bytes = 0;
  bool kept = false;
  bool lost = false;     // by damage to the recording
  bool refused = false;  // cannot be made a solid
  std::optional<Error> failure;
};

class Sequence {
 public:
  Sequence(const ConversionRequest& request, ConversionJob job, SequenceNames names,
           SequenceLog log)
      : format_(job.format),
        interrupted_(request.interrupted),
        later_(request.later()),
        names_(std::move(names)),
        log_(std::move(log)),
        companions_(companions_of(request, job)),
        model_(std::move(job.model)),
        frames_(std::move(job.frames)),
        readers_(request.recording, std::move(job.reader)),
        progress_("frame", static_cast<int>(frames_.size()), request.progress),
        outcomes_(frames_.size()) {}

  // What a kill has left of its files.
  void remove_leftovers() const {
    std::vector<std::filesystem::path> files = names_.frames();
    files.push_back(names_.log());
    for (const auto& folder : names_.folders())
      for (const Companion& companion : companions_) files.push_back(folder / companion.name);
    ribbon::remove_leftovers(files);
  }

  Result<ConversionReport> write() {
    auto written = write_all_companions();
    if (written) {
      parallel_ranges(frames_.size(), frames_per_range,
                      [this](std::size_t begin, std::size_t end) { write_range(begin, end); });
      progress_.end();
    }
    auto report = written.and_then([this] { return this->report(); });
    if (report || log_.empty()) log_.remove();
    return report;
  }

 private:
  Result<void> write_all_companions() {
    for (const auto& folder : names_.folders())
      if (auto written = write_companions(companions_, folder, later_); !written) return written;
    return {};
  }

  void write_range(std::size_t begin, std::size_t end) {
    if (stopped_) return;
    Result<RecordingReader> reader = readers_.take();
    if (!reader) return stop(outcomes_[begin], reader.error());
    Model model = model_;
    for (std::size_t slot = begin; slot < end && !stopped_; ++slot) {
      write_frame(*reader, model, slot);
      count_done();
    }
    readers_.give_back(std::move(*reader));
  }

  void write_frame(RecordingReader& reader, Model& model, std::size_t slot) {
    Outcome& outcome = outcomes_[slot];
    if (interrupted_()) return stop(outcome, {"", "interrupted", "go on with --resume", true});
    outcome.bytes = log_.complete_bytes(names_.number(slot), names_.frame(slot));
    outcome.kept = outcome.bytes > 0;
    if (outcome.kept) return;
    const int index = frames_[slot];
    Eigen::Matrix3Xf positions;
    outcome.lost = !reader.readable(index) || !reader.read(index, positions);
    if (outcome.lost) return;
    const Result<bool> posed = pose_ribbon(model, positions, index + 1);
    if (!posed) return stop(outcome, posed.error());
    outcome.refused = !*posed;
    if (*posed) write_model(model, slot);
  }

  void write_model(const Model& model, std::size_t slot) {
    Outcome& outcome = outcomes_[slot];
    const Result<std::string> bytes = encode_model(format_, model, names_.library());
    if (!bytes) return stop(outcome, bytes.error());
    const Result<void> written = write_file(names_.frame(slot), *bytes, later_).and_then([&] {
      return log_.add(names_.number(slot), *bytes);
    });
    if (!written) return stop(outcome, written.error());
    outcome.bytes = bytes->size();
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
    report.first_file = names_.frame(0);
    report.last_file = names_.frame(frames_.size() - 1);
    for (std::size_t slot = 0; slot < frames_.size(); ++slot) {
      const Outcome& outcome = outcomes_[slot];
      if (outcome.failure) return tl::unexpected(*outcome.failure);
      if (outcome.lost) report.missing.push_back(frames_[slot] + 1);
      if (outcome.refused) report.refused.push_back(frames_[slot] + 1);
      report.frames_written += outcome.lost || outcome.refused ? 0 : 1;
      report.frames_kept += outcome.kept ? 1 : 0;
      report.bytes_written += outcome.kept ? 0 : outcome.bytes;
    }
    if (report.frames_written == 0) return no_frames(model_, !report.refused.empty());
    return report;
  }

  OutputFormat format_;
  std::function<bool()> interrupted_;
  Older later_;
  SequenceNames names_;
  SequenceLog log_;
  std::vector<Companion> companions_;
  Model model_;
  std::vector<int> frames_;
  ReaderPool readers_;
  std::mutex progress_mutex_;
  ProgressLine progress_;
  int done_ = 0;
  std::vector<Outcome> outcomes_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace

Result<ConversionReport> write_frame_sequence(const ConversionRequest& request, ConversionJob job) {
  auto names = SequenceNames::of(request, job.frames);
  if (!names) return tl::unexpected(names.error());
  const std::string text = job_text(request, job);
  auto log = request.resume ? SequenceLog::resume(names->log(), text)
                            : SequenceLog::begin(names->log(), text);
  if (!log) return tl::unexpected(log.error());
  Sequence sequence(request, std::move(job), std::move(*names), std::move(*log));
  if (request.resume) sequence.remove_leftovers();
  return sequence.write();
}

}  // namespace ribbon
