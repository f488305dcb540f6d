#include "recording/writer/recording_writer.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>
#include <vector>

#include "recording/codec/position_encoder.h"
#include "recording/coding/checksum.h"
#include "recording/records/checkpoint_record.h"
#include "recording/records/header_record.h"
#include "recording/records/record_head.h"
#include "recording/records/session_record.h"
#include "recording/writer/index_builder.h"
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

struct RecordingWriter::State {
  State(RecordFile target, RecordedSoFar so_far)
      : file(std::move(target)),
        header(std::move(so_far.header)),
        recording_id(so_far.recording_id),
        frames(so_far.frames),
        last_frame(so_far.frames > 0 ? so_far.frames - 1 : 0),
        synced_frames(so_far.frames),
        index(std::move(so_far.indices), std::move(so_far.not_indexed)),
        encoder(codec_parameters(header), header.max_position_error_m),
        recent(std::move(so_far.recent)) {}

  RecordFile file;
  RecordingHeader header;
  std::uint32_t recording_id = 0;
  std::uint32_t frames = 0;         // one more than the highest frame number
  std::uint32_t last_frame = 0;     // appended last
  std::uint32_t synced_frames = 0;  // how many are known to be on the disk
  IndexBuilder index;
  PositionEncoder encoder;
  std::vector<DecodedFrame> recent;  // what the next frame may be predicted from
  WriterFigures figures;

  Result<void> write(std::string_view records);
  Result<void> write_index();
  Result<void> write_other(RecordType type, std::uint32_t frame, std::string_view payload);
  Result<QuantisedFrame> rounded(const Eigen::Matrix3Xd& positions);
  EncodedFrame encode(QuantisedFrame quantised, ReferenceList& references);
  void remember(QuantisedFrame quantised);
};

Result<void> RecordingWriter::State::write(std::string_view records) {
  const Timing timing(figures.writing_s);
  auto written = file.append(records);
  if (written) return written;
  Error error = std::move(written.error());
  error.problem += "; " + safe_frames(frames);
  if (frames > 0) error.remedy = "free some space and resume the run";
  return tl::unexpected(std::move(error));
}

Result<void> RecordingWriter::State::write_index() {
  const std::string record = index.record(recording_id);
  const std::uint64_t offset = file.size();
  auto written = write(record);
  if (written) index.written(offset, static_cast<std::uint32_t>(record.size()));
  return written;
}

Result<void> RecordingWriter::State::write_other(RecordType type, std::uint32_t frame,
                                                 std::string_view payload) {
  const std::string record = make_record(type, payload);
  const std::uint64_t offset = file.size();
  auto written = write(record);
  if (written) index.add(IndexedOther{type, frame, offset, record.size()});
  return written;
}

Result<QuantisedFrame> RecordingWriter::State::rounded(const Eigen::Matrix3Xd& positions) {
  const Timing timing(figures.encoding_s);
  auto quantised = encoder.rounded(positions);
  if (!quantised)
    quantised.error().place = file.path().string() + ": frame " + std::to_string(frames + 1);
  return quantised;
}

// Predicted from those of the frames it should be predicted from that are still at hand; after
// damage these may be fewer.
EncodedFrame RecordingWriter::State::encode(QuantisedFrame quantised, ReferenceList& references) {
  const Timing timing(figures.encoding_s);
  std::vector<const QuantisedFrame*> found_frames;
  for (const std::uint32_t wanted : live_references(frames)) {
    const auto found = std::find_if(recent.begin(), recent.end(), [wanted](const auto& decoded) {
      return decoded.frame == wanted;
    });
    if (found == recent.end()) continue;
    references.push_back(wanted);
    found_frames.push_back(&found->quantised);
  }
  return encoder.encode_rounded(std::move(quantised), found_frames, Prediction::p, Fit::quick);
}

void RecordingWriter::State::remember(QuantisedFrame quantised) {
  if (recent.size() < most_references) {
    recent.push_back({last_frame, std::move(quantised)});
    return;
  }
  const auto oldest = std::min_element(
      recent.begin(), recent.end(),
      [](const DecodedFrame& a, const DecodedFrame& b) { return a.frame < b.frame; });
  *oldest = {last_frame, std::move(quantised)};
}

RecordingWriter::RecordingWriter(RecordFile file, RecordedSoFar so_far)
    : state_(std::make_unique<State>(std::move(file), std::move(so_far))) {}
RecordingWriter::RecordingWriter(RecordingWriter&&) noexcept = default;
RecordingWriter& RecordingWriter::operator=(RecordingWriter&&) noexcept = default;
RecordingWriter::~RecordingWriter() = default;

Result<RecordingWriter> RecordingWriter::create(const std::filesystem::path& path,
                                                const RecordingHeader& header) {
  assert(!header.scene_name.empty() && header.uv.cols() == header.grid.particle_count());
  if (!is_recordable(header.grid))
    return failure(path.string(),
                   "a recording holds at most 2^24 particles in at most 2^20 columns, not " +
                       std::to_string(header.grid.along) + " x " +
                       std::to_string(header.grid.across),
                   "simulate fewer particles");
  auto file = RecordFile::create(path);
  if (!file) return tl::unexpected(std::move(file.error()));
  const std::string payload = header_payload(header);
  RecordingWriter writer(std::move(*file), {.header = header, .recording_id = checksum(payload)});
  auto written =
      writer.state_->write(std::string(file_signature) + make_record(RecordType::header, payload));
  if (!written) return tl::unexpected(std::move(written.error()));
  return writer;
}

Result<void> RecordingWriter::append(const FrameNumbers& numbers,
                                     const Eigen::Matrix3Xd& positions) {
  auto quantised = state_->rounded(positions);
  if (!quantised) return tl::unexpected(std::move(quantised.error()));
  return append(numbers, *std::move(quantised));
}

Result<void> RecordingWriter::append(const FrameNumbers& numbers, QuantisedFrame quantised) {
  State& state = *state_;
  assert(quantised.grid == state.header.grid);
  ReferenceList references;
  EncodedFrame encoded = state.encode(std::move(quantised), references);
  const std::uint32_t frame = state.frames;
  auto appended = append_encoded({.frame = frame,
                                  .encoding = encoded.encoding,
                                  .references = references,
                                  .numbers = numbers,
                                  .geometry = encoded.geometry});
  if (state.frames > frame) state.remember(std::move(encoded.frame));
  return appended;
}

Result<void> RecordingWriter::append_encoded(FrameRecord frame) {
  State& state = *state_;
  if (state.index.is_due())
    if (auto written = state.write_index(); !written) return written;
  frame.recording_id = state.recording_id;
  const std::string record = make_record(RecordType::frame, frame_payload(frame));
  const std::uint64_t offset = state.file.size();
  if (auto written = state.write(record); !written) return written;
  state.index.add(IndexedFrame{frame.frame, static_cast<std::uint32_t>(record.size()), offset,
                               frame.references, frame.numbers});
  state.last_frame = frame.frame;
  state.frames = std::max(state.frames, frame.frame + 1);
  return {};
}

Result<void> RecordingWriter::append_checkpoint(std::uint64_t steps, std::string_view state_bytes) {
  State& state = *state_;
  assert(state.frames > 0 && "a checkpoint belongs to a frame");
  if (state_bytes.size() > largest_state_bytes(state.header.grid))
    return failure(state.file.path().string(),
                   "cannot hold a checkpoint of " + std::to_string(state_bytes.size()) + " bytes",
                   "record without checkpoints");
  std::string payload;
  {
    const Timing timing(state.figures.encoding_s);
    payload = checkpoint_payload(state.recording_id, state.last_frame, steps, state_bytes);
  }
  return state.write_other(RecordType::checkpoint, state.last_frame, payload);
}

Result<void> RecordingWriter::append_session(const SessionNote& note) {
  return append_session(Session{state_->frames, note});
}

Result<void> RecordingWriter::append_session(const Session& session) {
  return state_->write_other(RecordType::session, session.first_frame,
                             session_payload(state_->recording_id, session));
}

Result<void> RecordingWriter::sync() {
  State& state = *state_;
  const Timing timing(state.figures.syncing_s);
  auto synced = state.file.sync();
  if (synced) {
    state.synced_frames = state.frames;
    return synced;
  }
  Error error = std::move(synced.error());
  error.problem += "; " + safe_frames(state.synced_frames);
  return tl::unexpected(std::move(error));
}

Result<void> RecordingWriter::finish(RunEnding ending) {
  State& state = *state_;
  if (state.index.is_waiting())
    if (auto written = state.write_index(); !written) return written;
  const std::uint64_t offset = state.file.size();
  auto written =
      state.write(make_record(RecordType::directory,
                              directory_payload(state.recording_id,
                                                {state.frames, ending, state.index.indices()})) +
                  make_record(RecordType::footer, footer_payload(state.recording_id, offset)));
  if (!written) return written;
  if (auto synced = sync(); !synced) return synced;
  return state.file.close();
}

const RecordingHeader& RecordingWriter::header() const {
  return state_->header;
}

std::uint32_t RecordingWriter::recording_id() const {
  return state_->recording_id;
}

std::uint64_t RecordingWriter::bytes_written() const {
  return state_->file.size();
}

std::uint32_t RecordingWriter::frames_written() const {
  return state_->frames;
}

WriterFigures RecordingWriter::figures() const {
  return state_->figures;
}

}  // namespace ribbon
