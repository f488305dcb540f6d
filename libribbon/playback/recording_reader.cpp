#include "playback/recording_reader.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "playback/frame_decoder.h"
#include "playback/recording_contents.h"
#include "recording/records/checkpoint_record.h"
#include "recording/records/session_record.h"

namespace ribbon {

struct RecordingReader::State {
  State(std::filesystem::path source, RandomAccessFile opened, RecordingStart read)
      : path(std::move(source)),
        file(std::move(opened)),
        start(std::move(read)),
        contents(file, start),
        decoder(file, start, contents) {}

  std::filesystem::path path;
  RandomAccessFile file;
  RecordingStart start;
  RecordingContents contents;
  FrameDecoder decoder;

  [[nodiscard]] std::string record_of(const IndexedOther& place) const {
    return file.read(place.offset, place.record_bytes);
  }

  // The directory is trusted until something is not as it says: a question whose answer is no is
  // then asked once more.
  template <class Question>
  auto surely(Question question) {
    auto answer = question();
    if (answer || contents.is_checked()) return answer;
    contents.check();
    return question();
  }
};

RecordingReader::RecordingReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
RecordingReader::RecordingReader(RecordingReader&&) noexcept = default;
RecordingReader& RecordingReader::operator=(RecordingReader&&) noexcept = default;
RecordingReader::~RecordingReader() = default;

Result<RecordingReader> RecordingReader::open(const std::filesystem::path& path) {
  auto file = RandomAccessFile::open(path);
  if (!file) return tl::unexpected(std::move(file.error()));
  auto start = read_start(*file, path);
  if (!start) return tl::unexpected(std::move(start.error()));
  return RecordingReader(std::make_unique<State>(path, std::move(*file), std::move(*start)));
}

const RecordingHeader& RecordingReader::header() const {
  return state_->start.header;
}

std::uint32_t RecordingReader::recording_id() const {
  return state_->start.recording_id;
}

int RecordingReader::frame_count() const {
  return static_cast<int>(state_->contents.frame_count());
}

bool RecordingReader::readable(int index) const {
  assert(index >= 0 && index < frame_count());
  const auto frame = static_cast<std::uint32_t>(index);
  return state_->surely([&] { return state_->decoder.is_readable(frame); });
}

std::optional<FrameNumbers> RecordingReader::numbers(int index) const {
  assert(index >= 0 && index < frame_count());
  const IndexedFrame* frame = state_->contents.find(static_cast<std::uint32_t>(index));
  return frame == nullptr ? std::nullopt : std::optional(frame->numbers);
}

bool RecordingReader::finished() const {
  return state_->contents.finished();
}

RunEnding RecordingReader::ending() const {
  return state_->contents.ending();
}

const std::vector<Damage>& RecordingReader::damage() const {
  return state_->contents.damage();
}

std::uint64_t RecordingReader::file_bytes() const {
  return state_->file.size();
}

std::vector<std::uint32_t> RecordingReader::checkpoints() const {
  std::vector<std::uint32_t> frames;
  for (const IndexedOther& other : state_->contents.others())
    if (other.type == RecordType::checkpoint) frames.push_back(other.frame);
  return frames;
}

Result<Checkpoint> RecordingReader::read_checkpoint(std::uint32_t frame) const {
  const auto& others = state_->contents.others();
  const auto place = std::find_if(others.rbegin(), others.rend(), [frame](const auto& other) {
    return other.type == RecordType::checkpoint && other.frame == frame;
  });
  const std::string name = state_->path.string() + ": frame " + std::to_string(frame + 1);
  if (place == others.rend())
    return failure(name, "has no checkpoint", "choose a frame that has one; --info lists them");
  const std::string record = state_->record_of(*place);
  const auto payload = whole_record(record, RecordType::checkpoint);
  auto checkpoint = payload ? parse_checkpoint_payload(*payload, state_->start.recording_id,
                                                       state_->start.header.grid)
                            : std::nullopt;
  if (!checkpoint || checkpoint->frame != frame)
    return failure(name, "the checkpoint is damaged", "choose an earlier one; --info lists them");
  return std::move(*checkpoint);
}

std::vector<Session> RecordingReader::sessions() const {
  std::vector<Session> sessions;
  for (const IndexedOther& other : state_->contents.others()) {
    if (other.type != RecordType::session) continue;
    const std::string record = state_->record_of(other);
    const auto payload = whole_record(record, RecordType::session);
    auto session =
        payload ? parse_session_payload(*payload, state_->start.recording_id) : std::nullopt;
    if (session) sessions.push_back(std::move(*session));
  }
  return sessions;
}

bool RecordingReader::is_being_written() const {
  return state_->file.is_being_written();
}

Result<void> RecordingReader::refresh() {
  State& state = *state_;
  if (!state.file.update_size()) return {};
  if (state.file.size() < state.contents.end())
    return failure(state.path.string(), "has become shorter while it was read",
                   "it is another recording now: open it again");
  state.contents.refresh();
  return {};
}

void RecordingReader::check() {
  state_->contents.check();
}

Result<void> RecordingReader::read(int index, Eigen::Matrix3Xf& positions) {
  const auto decoded = read_quantised(index);
  if (!decoded) return tl::unexpected(decoded.error());
  (*decoded)->positions(positions);
  return {};
}

Result<const QuantisedFrame*> RecordingReader::read_quantised(int index) {
  assert(index >= 0 && index < frame_count());
  State& state = *state_;
  const auto frame = static_cast<std::uint32_t>(index);
  const QuantisedFrame* decoded = state.surely([&] { return state.decoder.decode(frame); });
  if (decoded == nullptr)
    return failure(state.path.string() + ": frame " + std::to_string(index + 1),
                   "is damaged or builds on a frame that is",
                   "choose another frame or use a copy of the recording that is whole");
  return decoded;
}

}  // namespace ribbon
