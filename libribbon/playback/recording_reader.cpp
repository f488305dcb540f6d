#include "playback/recording_reader.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "recording/records/checkpoint_record.h"
#include "recording/records/session_record.h"

namespace ribbon {

RecordingReader::RecordingReader(std::filesystem::path path, OpenedRecording recording)
    : path_(std::move(path)), contents_(std::move(recording)), decoder_(header()) {}

Result<RecordingReader> RecordingReader::open(const std::filesystem::path& path) {
  auto recording = open_recording(path);
  if (!recording) return tl::unexpected(std::move(recording.error()));
  return RecordingReader(path, *std::move(recording));
}

// The directory is trusted until something is not as it says: a question whose answer is no is then
// asked once more.
template <class Question>
auto RecordingReader::surely(Question question) const {
  auto answer = question();
  if (answer || contents_.is_checked()) return answer;
  contents_.check();
  return question();
}

std::optional<std::string> RecordingReader::payload_of(const IndexedOther& other) const {
  return contents_.payload_at({other.type, other.offset, other.record_bytes});
}

const RecordingHeader& RecordingReader::header() const {
  return contents_.start().header;
}

std::uint32_t RecordingReader::recording_id() const {
  return contents_.start().recording_id;
}

int RecordingReader::frame_count() const {
  return static_cast<int>(contents_.frame_count());
}

bool RecordingReader::readable(int index) const {
  assert(index >= 0 && index < frame_count());
  const auto frame = static_cast<std::uint32_t>(index);
  return surely([&] { return decoder_.is_readable(contents_, frame); });
}

std::optional<FrameNumbers> RecordingReader::numbers(int index) const {
  assert(index >= 0 && index < frame_count());
  const IndexedFrame* frame = contents_.find(static_cast<std::uint32_t>(index));
  return frame == nullptr ? std::nullopt : std::optional(frame->numbers);
}

bool RecordingReader::finished() const {
  return contents_.finished();
}

RunEnding RecordingReader::ending() const {
  return contents_.ending();
}

const std::vector<Damage>& RecordingReader::damage() const {
  return contents_.damage();
}

std::uint64_t RecordingReader::file_bytes() const {
  return contents_.file().size();
}

std::vector<std::uint32_t> RecordingReader::checkpoints() const {
  std::vector<std::uint32_t> frames;
  for (const IndexedOther& other : contents_.others())
    if (other.type == RecordType::checkpoint) frames.push_back(other.frame);
  return frames;
}

Result<Checkpoint> RecordingReader::read_checkpoint(std::uint32_t frame) const {
  const auto& others = contents_.others();
  const auto found = std::find_if(others.rbegin(), others.rend(), [frame](const auto& other) {
    return other.type == RecordType::checkpoint && other.frame == frame;
  });
  const std::string name = path_.string() + ": frame " + std::to_string(frame + 1);
  if (found == others.rend())
    return failure(name, "has no checkpoint", "choose a frame that has one; --info lists them");
  const auto payload = payload_of(*found);
  auto checkpoint =
      payload ? parse_checkpoint_payload(*payload, recording_id(), header().grid) : std::nullopt;
  if (!checkpoint || checkpoint->frame != frame)
    return failure(name, "the checkpoint is damaged", "choose an earlier one; --info lists them");
  return std::move(*checkpoint);
}

std::vector<Session> RecordingReader::sessions() const {
  std::vector<Session> sessions;
  for (const IndexedOther& other : contents_.others()) {
    if (other.type != RecordType::session) continue;
    const auto payload = payload_of(other);
    auto session = payload ? parse_session_payload(*payload, recording_id()) : std::nullopt;
    if (session && session->first_frame == other.frame) sessions.push_back(std::move(*session));
  }
  return sessions;
}

bool RecordingReader::is_being_written() const {
  return contents_.file().is_being_written();
}

Result<void> RecordingReader::refresh() {
  if (contents_.refresh()) return {};
  return failure(path_.string(), "has become shorter while it was read",
                 "it is another recording now: open it again");
}

void RecordingReader::check() {
  contents_.check();
}

Result<void> RecordingReader::read(int index, Eigen::Matrix3Xf& positions) {
  const auto decoded = read_quantised(index);
  if (!decoded) return tl::unexpected(decoded.error());
  (*decoded)->positions(positions);
  return {};
}

Result<const QuantisedFrame*> RecordingReader::read_quantised(int index) {
  assert(index >= 0 && index < frame_count());
  const auto frame = static_cast<std::uint32_t>(index);
  const QuantisedFrame* decoded = surely([&] { return decoder_.decode(contents_, frame); });
  if (decoded == nullptr)
    return failure(path_.string() + ": frame " + std::to_string(index + 1),
                   "is damaged or builds on a frame that is",
                   "choose another frame or use a copy of the recording that is whole");
  return decoded;
}

}  // namespace ribbon
