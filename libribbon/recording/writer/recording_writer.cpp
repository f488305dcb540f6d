#include "recording/writer/recording_writer.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

#include "recording/coding/checksum.h"
#include "recording/records/checkpoint_record.h"
#include "recording/records/header_record.h"
#include "recording/records/session_record.h"

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
      so_far_(std::move(so_far)),
      last_frame_(so_far_.frames > 0 ? so_far_.frames - 1 : 0),
      synced_frames_(so_far_.frames),
      encoder_(codec_parameters(so_far_.header), so_far_.header.max_position_error_m) {}

Result<void> RecordingWriter::write(std::string_view records) {
  const Timing timing(figures_.writing_s);
  if (auto untouched = file_.check_is_as_written(); !untouched) return untouched;
  auto written = file_.append(records);
  if (written) return written;
  Error error = std::move(written.error());
  if (so_far_.frames > 0) error.remedy = "free some space and resume the run";
  error.remedy = safe_frames(so_far_.frames) + "; " + error.remedy;
  return tl::unexpected(std::move(error));
}

Result<void> RecordingWriter::write_index() {
  so_far_.not_indexed.previous = so_far_.indices.empty() ? 0 : so_far_.indices.back().offset;
  const std::string record =
      make_record(RecordType::index, index_payload(so_far_.recording_id, so_far_.not_indexed));
  const std::uint64_t offset = file_.size();
  auto written = write(record);
  if (!written) return written;
  so_far_.indices.push_back(
      location_of(so_far_.not_indexed, offset, static_cast<std::uint32_t>(record.size())));
  so_far_.not_indexed = {};
  return {};
}

Result<void> RecordingWriter::write_other(RecordType type, std::uint32_t frame,
                                          std::string_view payload) {
  const std::string record = make_record(type, payload);
  const std::uint64_t offset = file_.size();
  auto written = write(record);
  if (written) so_far_.not_indexed.others.push_back({type, frame, offset, record.size()});
  return written;
}

Result<RecordingWriter> RecordingWriter::create(const std::filesystem::path& path,
                                                const RecordingHeader& header,
                                                Overwrite overwrite) {
  assert(!header.scene_name.empty() && header.uv.cols() == header.grid.particle_count());
  if (auto fits = check_recordable(header); !fits) {
    fits.error().place = path.string();
    return tl::unexpected(std::move(fits.error()));
  }
  auto file = RecordFile::create(path, overwrite);
  if (!file) return tl::unexpected(std::move(file.error()));
  const std::string payload = header_payload(header);
  RecordingWriter writer(std::move(*file), {.header = header, .recording_id = checksum(payload)});
  writer.waits_ = overwrite == Overwrite::when_told;
  auto written =
      writer.write(std::string(file_signature) + make_record(RecordType::header, payload));
  if (written) return writer;
  writer.take_back();
  return tl::unexpected(std::move(written.error()));
}

Result<void> RecordingWriter::append(const FrameNumbers& numbers,
                                     const Eigen::Matrix3Xd& positions) {
  const auto rounded = [&] {
    const Timing timing(figures_.encoding_s);
    return encoder_.rounded(positions);
  };
  auto quantised = rounded();
  if (quantised) return append(numbers, *std::move(quantised));
  quantised.error().place = file_.path().string() + ": frame " + std::to_string(so_far_.frames + 1);
  return tl::unexpected(std::move(quantised.error()));
}

Result<void> RecordingWriter::append(const FrameNumbers& numbers, QuantisedFrame quantised) {
  assert(quantised.grid == so_far_.header.grid);
  FrameRecord record{.frame = so_far_.frames, .numbers = numbers};
  // After damage the frame that it should be predicted from may be lost.
  if (so_far_.last && so_far_.last->frame == reference_of(so_far_.frames))
    record.reference = so_far_.last->frame;
  EncodedFrame encoded;
  {
    const Timing timing(figures_.encoding_s);
    encoded = encoder_.encode_rounded(std::move(quantised),
                                      record.reference ? &so_far_.last->quantised : nullptr);
  }
  record.encoding = encoded.encoding;
  record.geometry = encoded.geometry;
  auto appended = append_encoded(record);
  if (so_far_.frames > record.frame) so_far_.last = {record.frame, std::move(encoded.frame)};
  return appended;
}

Result<void> RecordingWriter::append_encoded(FrameRecord frame) {
  if (so_far_.not_indexed.frames.size() >= frames_in_index)
    if (auto written = write_index(); !written) return written;
  frame.recording_id = so_far_.recording_id;
  const std::string record = make_record(RecordType::frame, frame_payload(frame));
  const std::uint64_t offset = file_.size();
  if (auto written = write(record); !written) return written;
  so_far_.not_indexed.frames.push_back({frame.frame, static_cast<std::uint32_t>(record.size()),
                                        offset, frame.reference, frame.numbers});
  last_frame_ = frame.frame;
  so_far_.frames = std::max(so_far_.frames, frame.frame + 1);
  return waits_ ? Result<void>() : take_place();
}

Result<void> RecordingWriter::append_checkpoint(std::uint64_t steps, std::string_view state_bytes) {
  assert(so_far_.frames > 0 && "a checkpoint belongs to a frame");
  if (state_bytes.size() > largest_state_bytes(so_far_.header.grid))
    return failure(file_.path().string(),
                   "cannot hold a checkpoint of " + std::to_string(state_bytes.size()) + " bytes",
                   "record without checkpoints");
  std::string payload;
  {
    const Timing timing(figures_.encoding_s);
    payload = checkpoint_payload(so_far_.recording_id, last_frame_, steps, state_bytes);
  }
  return write_other(RecordType::checkpoint, last_frame_, payload);
}

Result<void> RecordingWriter::append_session(const SessionNote& note) {
  return write_other(RecordType::session, so_far_.frames,
                     session_payload(so_far_.recording_id, Session{so_far_.frames, note}));
}

Result<void> RecordingWriter::sync() {
  const Timing timing(figures_.syncing_s);
  auto synced = file_.sync();
  if (synced) {
    synced_frames_ = so_far_.frames;
    return synced;
  }
  Error error = std::move(synced.error());
  error.remedy = safe_frames(synced_frames_) + "; " + error.remedy;
  return tl::unexpected(std::move(error));
}

Result<void> RecordingWriter::finish(RunEnding ending) {
  if (!so_far_.not_indexed.frames.empty() || !so_far_.not_indexed.others.empty())
    if (auto written = write_index(); !written) return written;
  const std::uint64_t offset = file_.size();
  auto written =
      write(make_record(RecordType::directory,
                        directory_payload(so_far_.recording_id,
                                          {so_far_.frames, ending, so_far_.indices})) +
            make_record(RecordType::footer, footer_payload(so_far_.recording_id, offset)));
  if (!written) return written;
  if (waits_ || so_far_.frames > 0)
    if (auto taken = file_.take_place(); !taken) return taken;
  if (auto synced = sync(); !synced) return synced;
  return file_.close();
}

}  // namespace ribbon
