#include "recording/recording_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cassert>
#include <utility>
#include <vector>

#include "files/descriptor.h"
#include "recording/checksum.h"
#include "recording/frame_record.h"
#include "recording/header_record.h"
#include "recording/index_record.h"
#include "recording/position_encoder.h"
#include "recording/record.h"
#include "recording/references.h"
#include "recording/tightness_record.h"

namespace ribbon {

struct RecordingWriter::State {
  State(std::filesystem::path target, const RecordingHeader& header)
      : path(std::move(target)), encoder(codec_parameters(header), header.max_position_error_m) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  State(State&&) = delete;
  State& operator=(State&&) = delete;
  ~State() {
    if (descriptor >= 0) ::close(descriptor);
  }

  std::filesystem::path path;
  int descriptor = -1;
  std::uint32_t recording_id = 0;
  std::uint64_t frames_begin = 0;
  std::uint64_t bytes = 0;
  PositionEncoder encoder;
  std::array<LatticeFrame, most_references + 1> recent;  // by frame number, modulo their count
  std::vector<IndexEntry> entries;

  Result<void> open();
  Result<void> write(std::string_view record);
  [[nodiscard]] std::string complete_up_to() const;
};

Result<void> RecordingWriter::State::open() {
  std::error_code code;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), code);
  if (code)
    return failure(path.parent_path().string(), "cannot be created (" + code.message() + ")",
                   "choose a folder that you may write to");
  descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0)
    return failure(path.string(), "cannot be written (" + last_error_text() + ")",
                   "choose a file that you may write to");
  return {};
}

std::string RecordingWriter::State::complete_up_to() const {
  return entries.empty()
             ? "the recording holds no frame"
             : "the recording is complete up to frame " + std::to_string(entries.size());
}

// What a failed write left of the record is taken back, so that the file ends with a whole record.
Result<void> RecordingWriter::State::write(std::string_view record) {
  if (write_all(descriptor, record)) {
    bytes += record.size();
    return {};
  }
  const std::string reason = last_error_text();
  if (::ftruncate(descriptor, static_cast<off_t>(bytes)) == 0)
    ::lseek(descriptor, static_cast<off_t>(bytes), SEEK_SET);
  return failure(path.string(), "cannot be written (" + reason + ") and " + complete_up_to(),
                 "free some space or choose another place");
}

namespace {

// Empty where the frame has none.
std::string tightness_record(const FrameRecord& frame) {
  if (!frame.numbers.tightness) return "";
  return make_record(RecordType::tightness, tightness_payload({frame.recording_id, frame.frame,
                                                               *frame.numbers.tightness}));
}

}  // namespace

RecordingWriter::RecordingWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
RecordingWriter::RecordingWriter(RecordingWriter&&) noexcept = default;
RecordingWriter& RecordingWriter::operator=(RecordingWriter&&) noexcept = default;
RecordingWriter::~RecordingWriter() = default;

Result<RecordingWriter> RecordingWriter::create(const std::filesystem::path& path,
                                                const RecordingHeader& header) {
  assert(!header.scene_name.empty() && header.max_position_error_m >= 0);
  assert(header.uv.cols() == header.grid.particle_count());
  auto state = std::make_unique<State>(path, header);
  if (auto opened = state->open(); !opened) return tl::unexpected(std::move(opened.error()));
  const std::string payload = header_payload(header);
  state->recording_id = checksum(payload);
  auto written =
      state->write(std::string(file_signature) + make_record(RecordType::header, payload));
  if (!written) return tl::unexpected(std::move(written.error()));
  state->frames_begin = state->bytes;
  return RecordingWriter(std::move(state));
}

Result<void> RecordingWriter::append(const FrameNumbers& numbers,
                                     const Eigen::Matrix3Xd& positions) {
  State& state = *state_;
  assert(state.descriptor >= 0 && "not after finish()");
  std::vector<const LatticeFrame*> references;
  for (const std::uint32_t reference : live_references(frames_written()))
    references.push_back(&state.recent[reference % state.recent.size()]);
  auto encoded = state.encoder.encode(positions, references);
  if (!encoded) {
    Error error = std::move(encoded.error());
    error.place = state.path.string() + ": frame " + std::to_string(state.entries.size() + 1);
    return tl::unexpected(std::move(error));
  }
  FrameRecord frame;
  frame.recording_id = state.recording_id;
  frame.frame = frames_written();
  frame.frames_since_key = frames_written() % live_group_frames;
  frame.encoding = encoded->encoding;
  frame.numbers = numbers;
  frame.geometry = encoded->geometry;
  const std::string record = make_record(RecordType::frame, frame_payload(frame));
  const std::string tightness = tightness_record(frame);
  const std::uint64_t offset = state.bytes + tightness.size();
  auto written = state.write(tightness + record);
  if (!written) return written;
  state.recent[frames_written() % state.recent.size()] = std::move(encoded->frame);
  state.entries.push_back(
      {offset, static_cast<std::uint32_t>(record.size()), frame.frames_since_key, numbers});
  return {};
}

Result<void> RecordingWriter::finish(RunEnding ending) {
  State& state = *state_;
  assert(state.descriptor >= 0 && "only once");
  const std::uint64_t index_offset = state.bytes;
  auto written = state.write(
      make_record(RecordType::index,
                  index_payload(state.recording_id, {state.entries, ending}, state.frames_begin)) +
      make_record(RecordType::footer, footer_payload(state.recording_id, index_offset)));
  if (!written) return written;
  // Pipes and devices cannot be forced to the disk, and need not be.
  const bool synced = ::fsync(state.descriptor) == 0 || errno == EINVAL || errno == EROFS;
  std::string problem = synced ? "" : last_error_text();
  if (::close(std::exchange(state.descriptor, -1)) != 0 && problem.empty())
    problem = last_error_text();
  if (!problem.empty())
    return failure(state.path.string(), "may not have reached the disk (" + problem + ")",
                   "check the disk");
  return {};
}

std::uint64_t RecordingWriter::bytes_written() const {
  return state_->bytes;
}

std::uint32_t RecordingWriter::frames_written() const {
  return static_cast<std::uint32_t>(state_->entries.size());
}

}  // namespace ribbon
