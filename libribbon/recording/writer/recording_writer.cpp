#include "recording/writer/recording_writer.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

#include "recording/coding/checksum.h"
#include "recording/records/checkpoint_record.h"
#include "recording/records/header_record.h"
#include "recording/records/session_record.h"
#include "recording/writer/references.h"

namespace ribbon {

namespace {

// Adds the time until its end to a figure.
class Timing {
 public:
  explicit Timing(double& sum_s) : sum_s_(sum_s) {}
  Timing(const Timing&) = delete;
  Timing& operator=(const Timing&) = delete;
  ~Timing() {
    sum_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  double& sum_s_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string safe_frames(std::uint32_t frames) {
  if (frames == 0) return "the recording holds no frame";
  if (frames == 1) return "frame 1 is safe";
  return "frames 1 to " + std::to_string(frames) + " are safe";
}

}  // namespace

RecordingWriter::RecordingWriter(RecordFile file, RecordedSoFar so_far)
    : file_(std::move(file)),
      header_(std::move(so_far.header)),
      recording_id_(so_far.recording_id),
      frames_(so_far.frames),
      last_frame_(so_far.frames > 0 ? so_far.frames - 1 : 0),
      synced_frames_(so_far.frames),
      index_(std::move(so_far.indices), std::move(so_far.not_indexed)),
      encoder_(codec_parameters(header_), header_.max_position_error_m),
      recent_(std::move(so_far.recent)) {}

Result<void> RecordingWriter::write(std::string_view records) {
  const Timing timing(figures_.writing_s);
  auto written = file_.append(records);
  if (written) return written;
  Error error = std::move(written.error());
  error.problem += "; " + safe_frames(frames_);
  if (frames_ > 0) error.remedy = "free some space and resume the run";
  return tl::unexpected(std::move(error));
}

Result<void> RecordingWriter::write_index() {
  const std::string record = index_.record(recording_id_);
  const std::uint64_t offset = file_.size();
  auto written = write(record);
  if (written) index_.written(offset, static_cast<std::uint32_t>(record.size()));
  return written;
}

Result<void> RecordingWriter::write_other(RecordType type, std::uint32_t frame,
                                          std::string_view payload) {
  const std::string record = make_record(type, payload);
  const std::uint64_t offset = file_.size();
  auto written = write(record);
  if (written) index_.add(IndexedOther{type, frame, offset, record.size()});
  return written;
}

Result<QuantisedFrame> RecordingWriter::rounded(const Eigen::Matrix3Xd& positions) {
  const Timing timing(figures_.encoding_s);
  auto quantised = encoder_.rounded(positions);
  if (!quantised)
    quantised.error().place = file_.path().string() + ": frame " + std::to_string(frames_ + 1);
  return quantised;
}

// Nothing where it is no longer at hand.
const QuantisedFrame* RecordingWriter::recent(std::uint32_t frame) const {
  const auto found = std::find_if(recent_.begin(), recent_.end(),
                                  [frame](const auto& decoded) { return decoded.frame == frame; });
  return found == recent_.end() ? nullptr : &found->quantised;
}

// Predicted from those of the frames it should be predicted from that are still at hand; after
// damage these may be fewer.
EncodedFrame RecordingWriter::encode(QuantisedFrame quantised, ReferenceList& references) {
  const Timing timing(figures_.encoding_s);
  for (const std::uint32_t wanted : references_of(frames_))
    if (recent(wanted) != nullptr) references.push_back(wanted);
  const auto frames = frames_of(references, [this](std::uint32_t frame) { return recent(frame); });
  return encoder_.encode_rounded(std::move(quantised), frames);
}

void RecordingWriter::remember(QuantisedFrame quantised) {
  if (recent_.size() < most_references) {
    recent_.push_back({last_frame_, std::move(quantised)});
    return;
  }
  const auto oldest = std::min_element(
      recent_.begin(), recent_.end(),
      [](const DecodedFrame& a, const DecodedFrame& b) { return a.frame < b.frame; });
  *oldest = {last_frame_, std::move(quantised)};
}

Result<RecordingWriter> RecordingWriter::create(const std::filesystem::path& path,
                                                const RecordingHeader& header,
                                                Overwrite overwrite) {
  assert(!header.scene_name.empty() && header.uv.cols() == header.grid.particle_count());
  if (!is_recordable(header.grid))
    return failure(path.string(),
                   "a recording holds at most 2^24 particles in at most 2^20 columns, not " +
                       std::to_string(header.grid.along) + " x " +
                       std::to_string(header.grid.across),
                   "simulate fewer particles");
  auto file = RecordFile::create(path, overwrite);
  if (!file) return tl::unexpected(std::move(file.error()));
  const std::string payload = header_payload(header);
  RecordingWriter writer(std::move(*file), {.header = header, .recording_id = checksum(payload)});
  auto written =
      writer.write(std::string(file_signature) + make_record(RecordType::header, payload));
  if (!written) return tl::unexpected(std::move(written.error()));
  return writer;
}

Result<void> RecordingWriter::append(const FrameNumbers& numbers,
                                     const Eigen::Matrix3Xd& positions) {
  auto quantised = rounded(positions);
  if (!quantised) return tl::unexpected(std::move(quantised.error()));
  return append(numbers, *std::move(quantised));
}

Result<void> RecordingWriter::append(const FrameNumbers& numbers, QuantisedFrame quantised) {
  assert(quantised.grid == header_.grid);
  ReferenceList references;
  EncodedFrame encoded = encode(std::move(quantised), references);
  const std::uint32_t frame = frames_;
  auto appended = append_encoded({.frame = frame,
                                  .encoding = encoded.encoding,
                                  .references = references,
                                  .numbers = numbers,
                                  .geometry = encoded.geometry});
  if (frames_ > frame) remember(std::move(encoded.frame));
  return appended;
}

Result<void> RecordingWriter::append_encoded(FrameRecord frame) {
  if (index_.is_due())
    if (auto written = write_index(); !written) return written;
  frame.recording_id = recording_id_;
  const std::string record = make_record(RecordType::frame, frame_payload(frame));
  const std::uint64_t offset = file_.size();
  if (auto written = write(record); !written) return written;
  index_.add(IndexedFrame{frame.frame, static_cast<std::uint32_t>(record.size()), offset,
                          frame.references, frame.numbers});
  last_frame_ = frame.frame;
  frames_ = std::max(frames_, frame.frame + 1);
  return {};
}

Result<void> RecordingWriter::append_checkpoint(std::uint64_t steps, std::string_view state_bytes) {
  assert(frames_ > 0 && "a checkpoint belongs to a frame");
  if (state_bytes.size() > largest_state_bytes(header_.grid))
    return failure(file_.path().string(),
                   "cannot hold a checkpoint of " + std::to_string(state_bytes.size()) + " bytes",
                   "record without checkpoints");
  std::string payload;
  {
    const Timing timing(figures_.encoding_s);
    payload = checkpoint_payload(recording_id_, last_frame_, steps, state_bytes);
  }
  return write_other(RecordType::checkpoint, last_frame_, payload);
}

Result<void> RecordingWriter::append_session(const SessionNote& note) {
  return write_other(RecordType::session, frames_,
                     session_payload(recording_id_, Session{frames_, note}));
}

Result<void> RecordingWriter::sync() {
  const Timing timing(figures_.syncing_s);
  auto synced = file_.sync();
  if (synced) {
    synced_frames_ = frames_;
    return synced;
  }
  Error error = std::move(synced.error());
  error.problem += "; " + safe_frames(synced_frames_);
  return tl::unexpected(std::move(error));
}

Result<void> RecordingWriter::finish(RunEnding ending) {
  if (index_.is_waiting())
    if (auto written = write_index(); !written) return written;
  const std::uint64_t offset = file_.size();
  auto written =
      write(make_record(RecordType::directory,
                        directory_payload(recording_id_, {frames_, ending, index_.indices()})) +
            make_record(RecordType::footer, footer_payload(recording_id_, offset)));
  if (!written) return written;
  if (auto synced = sync(); !synced) return synced;
  return file_.close();
}

}  // namespace ribbon
