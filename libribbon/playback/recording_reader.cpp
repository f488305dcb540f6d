#include "playback/recording_reader.h"

#include <array>
#include <cassert>
#include <utility>

#include "playback/frame_table.h"
#include "playback/random_access_file.h"
#include "recording/checksum.h"
#include "recording/header_record.h"
#include "recording/position_decoder.h"
#include "recording/record.h"
#include "recording/references.h"

namespace ribbon {

struct RecordingReader::State {
  State(std::filesystem::path source, RandomAccessFile opened, RecordingHeader read_header)
      : path(std::move(source)),
        file(std::move(opened)),
        header(std::move(read_header)),
        decoder(codec_parameters(header)) {}

  std::filesystem::path path;
  RandomAccessFile file;
  RecordingHeader header;
  std::uint32_t recording_id = 0;
  std::uint64_t frames_begin = 0;
  FrameTable table;
  bool scanned = false;
  PositionDecoder decoder;
  std::array<LatticeFrame, most_references + 1> recent;  // by frame number, modulo their count
  int decoded = -1;                                      // the frame decoded last

  void scan();
  bool decode_up_to(int index);
  bool decode(int index);
};

void RecordingReader::State::scan() {
  // The number of frames that the index promised stays, so that lost ones at the end still count.
  const std::size_t promised = table.frames.size();
  std::vector<Damage> header_damage = std::move(table.damage);
  FrameTable found = table_from_scan(file, recording_id, frames_begin);
  found.finished = found.finished || table.finished;
  if (found.frames.size() < promised) found.frames.resize(promised);
  found.damage.insert(found.damage.begin(), header_damage.begin(), header_damage.end());
  table = std::move(found);
  scanned = true;
}

bool RecordingReader::State::decode(int index) {
  const FrameEntry& entry = table.frames[static_cast<std::size_t>(index)];
  std::string bytes;
  const auto record =
      read_frame_record(file, entry, recording_id, static_cast<std::uint32_t>(index), bytes);
  decoded = -1;
  if (!record) return false;
  std::vector<const LatticeFrame*> references;
  for (const std::uint32_t reference : live_references(record->frame))
    references.push_back(&recent[reference % recent.size()]);
  LatticeFrame& frame = recent[record->frame % recent.size()];
  if (!decoder.decode(record->encoding, record->geometry, references, frame)) return false;
  decoded = index;
  return true;
}

// From the frame that the decoder holds where that is on the way, from the key frame otherwise.
bool RecordingReader::State::decode_up_to(int index) {
  const auto since_key = table.frames[static_cast<std::size_t>(index)].frames_since_key;
  const int key = index - static_cast<int>(since_key);
  int next = decoded >= key && decoded <= index ? decoded + 1 : key;
  for (; next <= index; ++next)
    if (!decode(next)) return false;
  return true;
}

RecordingReader::RecordingReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
RecordingReader::RecordingReader(RecordingReader&&) noexcept = default;
RecordingReader& RecordingReader::operator=(RecordingReader&&) noexcept = default;
RecordingReader::~RecordingReader() = default;

Result<RecordingReader> RecordingReader::open(const std::filesystem::path& path) {
  auto file = RandomAccessFile::open(path);
  if (!file) return tl::unexpected(std::move(file.error()));
  const bool signed_file = file->read(0, file_signature.size()) == file_signature;
  const auto head = parse_record_head(file->read(file_signature.size(), record_head_bytes));
  if (!signed_file && !head)
    return failure(path.string(), "is not a ribbon recording", "name a file by ribbon-record");
  const std::uint64_t payload_offset = file_signature.size() + record_head_bytes;
  const std::string payload = head ? file->read(payload_offset, head->payload_bytes) : "";
  if (!head || head->type != RecordType::header || payload.size() != head->payload_bytes ||
      checksum(payload) != head->payload_checksum)
    return failure(path.string(), "the header is cut off or damaged",
                   "use a copy of the recording that is whole");
  auto header = parse_header_payload(payload);
  if (!header) {
    header.error().place = path.string();
    return tl::unexpected(std::move(header.error()));
  }
  auto state = std::make_unique<State>(path, std::move(*file), std::move(*header));
  state->recording_id = head->payload_checksum;
  state->frames_begin = payload_offset + head->payload_bytes;
  if (!signed_file)
    state->table.damage.push_back({0, file_signature.size(), "the file's signature is wrong"});
  auto indexed = table_from_index(state->file, state->recording_id, state->frames_begin);
  if (indexed) {
    indexed->damage = std::move(state->table.damage);
    state->table = std::move(*indexed);
  } else {
    state->scan();
  }
  return RecordingReader(std::move(state));
}

const RecordingHeader& RecordingReader::header() const {
  return state_->header;
}

int RecordingReader::frame_count() const {
  return static_cast<int>(state_->table.frames.size());
}

bool RecordingReader::readable(int index) const {
  return state_->table.frames.at(static_cast<std::size_t>(index)).readable;
}

const std::optional<FrameNumbers>& RecordingReader::numbers(int index) const {
  return state_->table.frames.at(static_cast<std::size_t>(index)).numbers;
}

bool RecordingReader::finished() const {
  return state_->table.finished;
}

RunEnding RecordingReader::ending() const {
  return state_->table.ending;
}

const std::vector<Damage>& RecordingReader::damage() const {
  return state_->table.damage;
}

std::uint64_t RecordingReader::file_bytes() const {
  return state_->file.size();
}

void RecordingReader::check() {
  if (!state_->scanned) state_->scan();
}

Result<void> RecordingReader::read(int index, Eigen::Matrix3Xf& positions) {
  assert(index >= 0 && index < frame_count());
  State& state = *state_;
  bool decoded = readable(index) && state.decode_up_to(index);
  if (!decoded && !state.scanned) {
    // The index was trusted and something is not as it says.
    state.scan();
    decoded = readable(index) && state.decode_up_to(index);
  }
  if (!decoded)
    return failure(state.path.string() + ": frame " + std::to_string(index + 1),
                   "is damaged or builds on a frame that is",
                   "choose another frame or use a copy of the recording that is whole");
  state.recent[static_cast<std::size_t>(index) % state.recent.size()].positions(positions);
  return {};
}

}  // namespace ribbon
