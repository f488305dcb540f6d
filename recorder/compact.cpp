#include "recorder/compact.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "files/files.h"
#include "files/part_file.h"
#include "playback/recording_reader.h"
#include "recorder/copied_frames.h"
#include "recording/records/header_record.h"
#include "recording/writer/compact_encoder.h"
#include "recording/writer/record_file.h"
#include "recording/writer/recording_writer.h"
#include "recording/writer/references.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;

// Writes the frames of one recording into another, in the order of compaction_plan().
class Compactor {
 public:
  Compactor(RecordingReader& source, RecordingWriter& target)
      : source_(source),
        target_(target),
        encoder_(codec_parameters(source.header()), source.header().max_position_error_m),
        checkpoints_(kept_checkpoints(source.checkpoints())) {}

  Result<void> take(const PlannedFrame& planned) {
    const std::uint32_t frame = planned.frame;
    if (planned.references.size() == 0) forget_group();
    const auto quantised = source_.read_quantised(static_cast<int>(frame));
    if (!quantised) return tl::unexpected(quantised.error());
    const QuantisedFrame& decoded = coded_[frame] = **quantised;
    const CompactedFrame compacted =
        encoder_.encode(decoded, planned.references,
                        [this](std::uint32_t reference) { return &coded_.at(reference); });
    auto written = target_.append_encoded({.frame = frame,
                                           .encoding = compacted.encoded.encoding,
                                           .references = compacted.references,
                                           .numbers = *source_.numbers(static_cast<int>(frame)),
                                           .geometry = compacted.encoded.geometry});
    return written && has_checkpoint(frame) ? take_checkpoint(frame) : written;
  }

 private:
  // Only the last frame of a group is also the first of the next one.
  void forget_group() {
    if (!coded_.empty()) coded_.erase(coded_.begin(), std::prev(coded_.end()));
  }

  [[nodiscard]] bool has_checkpoint(std::uint32_t frame) const {
    return std::find(checkpoints_.begin(), checkpoints_.end(), frame) != checkpoints_.end();
  }
  Result<void> take_checkpoint(std::uint32_t frame) {
    const auto checkpoint = source_.read_checkpoint(frame);
    if (!checkpoint) return tl::unexpected(checkpoint.error());
    return target_.append_checkpoint(checkpoint->steps, checkpoint->state);
  }

  RecordingReader& source_;
  RecordingWriter& target_;
  CompactEncoder encoder_;
  std::vector<std::uint32_t> checkpoints_;
  std::map<std::uint32_t, QuantisedFrame> coded_;  // of this group, by number
};

// Nothing is left out of a recording without its owner's knowing.
Result<void> check_undamaged(const fs::path& path, RecordingReader& source) {
  if (!first_lost_frame(source, source.frame_count()) && source.damage().empty()) return {};
  return failure(path.string(), "is damaged, and compacting it would make that final",
                 "compact a copy that is whole, or leave it: it plays as far as it can be read");
}

// Whether all frames have been taken: not where the observer gives up.
Result<bool> copy(RecordingReader& source, RecordingWriter& target,
                  const std::function<bool(int done, int total)>& go_on) {
  Compactor compactor(source, target);
  int done = 0;
  for (const PlannedFrame& planned :
       compaction_plan(static_cast<std::uint32_t>(source.frame_count()))) {
    if (auto taken = compactor.take(planned); !taken) return tl::unexpected(taken.error());
    if (go_on && !go_on(++done, source.frame_count())) return false;
  }
  for (const Session& session : source.sessions())
    if (auto taken = target.append_session(session); !taken) return tl::unexpected(taken.error());
  // What a run was not allowed to finish stays as that: it can be resumed likewise.
  auto ended = source.finished() ? target.finish(source.ending()) : target.sync();
  if (!ended) return tl::unexpected(ended.error());
  return true;
}

// All but the frames.
bool same_rest(const RecordingReader& a, const RecordingReader& b) {
  const auto same_checkpoint = [&](std::uint32_t frame) {
    const auto in_a = a.read_checkpoint(frame);
    const auto in_b = b.read_checkpoint(frame);
    return in_a && in_b && *in_a == *in_b;
  };
  const auto checkpoints = kept_checkpoints(a.checkpoints());
  return header_payload(a.header()) == header_payload(b.header()) &&
         a.frame_count() == b.frame_count() && a.sessions() == b.sessions() &&
         a.finished() == b.finished() && a.ending() == b.ending() &&
         checkpoints == kept_checkpoints(b.checkpoints()) &&
         std::all_of(checkpoints.begin(), checkpoints.end(), same_checkpoint);
}

// Whether all frames have been compared: not where the observer gives up.
Result<bool> compare(const fs::path& path, const fs::path& part,
                     const std::function<bool(int done, int total)>& go_on) {
  const auto otherwise = [&](const std::string& what) {
    return failure(path.string() + what, "it would not come out as it was",
                   "report this; the recording is as it was");
  };
  auto before = RecordingReader::open(path);
  if (!before) return tl::unexpected(before.error());
  auto after = RecordingReader::open(part);
  if (!after) return tl::unexpected(after.error());
  if (!same_rest(*before, *after)) return otherwise("");
  const int frames = before->frame_count();
  for (int frame = 0; frame < frames; ++frame) {
    if (!same_frame(*before, *after, frame)) return otherwise(filled_in(": frame {}", frame + 1));
    if (go_on && !go_on(frame + 1, frames)) return false;
  }
  return true;
}

// The writer says what is safe in its own file; that is of no interest here.
tl::unexpected<Error> not_compacted(const fs::path& path, const Error& error) {
  return failure(path.string(),
                 "cannot be compacted: the smaller one beside it " +
                     error.problem.substr(0, error.problem.find(';')),
                 "free some space or check the folder; the recording is as it was");
}

}  // namespace

std::vector<std::uint32_t> kept_checkpoints(std::vector<std::uint32_t> frames) {
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  if (frames.size() > 3) frames.erase(frames.begin() + 1, frames.end() - 2);
  return frames;
}

Result<std::optional<Compaction>> compact(const fs::path& recording,
                                          const CompactionObserver& observer) {
  std::error_code code;
  const fs::path named = fs::canonical(recording, code);  // what links lead to is replaced
  const fs::path path = code ? recording : named;
  // Read before it is opened for writing, so that what is no recording is told as such,
  if (auto opened = RecordingReader::open(path); !opened) return tl::unexpected(opened.error());
  const auto lock = RecordFile::open(path);
  if (!lock) return tl::unexpected(lock.error());
  // and again now that nobody else can write it.
  auto source = RecordingReader::open(path);
  if (!source) return tl::unexpected(source.error());
  if (auto whole = check_undamaged(path, *source); !whole) return tl::unexpected(whole.error());

  const PartFile part(path);
  Compaction compaction{source->frame_count(), source->file_bytes(), source->file_bytes()};
  {
    auto target = RecordingWriter::create(part.path(), source->header());
    if (!target) return not_compacted(path, target.error());
    const auto copied = copy(*source, *target, observer.frame_written);
    if (!copied) return not_compacted(path, copied.error());
    if (!*copied) return std::nullopt;
    if (target->bytes_written() >= compaction.bytes_before) return compaction;
    compaction.bytes_after = target->bytes_written();
  }
  const auto same = compare(path, part.path(), observer.frame_compared);
  if (!same) return tl::unexpected(same.error());
  if (!*same) return std::nullopt;
  fs::permissions(part.path(), fs::status(path, code).permissions(), code);
  if (auto replaced = replace_file(path, part.path()); !replaced)
    return tl::unexpected(replaced.error());
  return compaction;
}

}  // namespace ribbon
