#include "playback/frame_decoder.h"

#include <algorithm>
#include <string>
#include <utility>

#include "recording/records/frame_record.h"

namespace ribbon {

namespace {

// Enough for playing in order, whichever way frames are predicted from each other.
constexpr std::size_t slots_kept = 24;

// So many others a frame may need (FORMAT.md, section 5.1).
constexpr std::size_t most_needed = 256;

}  // namespace

FrameDecoder::Slot* FrameDecoder::at_hand(std::uint32_t frame) {
  for (const auto& slot : slots_)
    if (slot->last_use > 0 && slot->frame == frame) return slot.get();
  return nullptr;
}

// The frame and what it needs, in the order in which to decode them; nothing where one is lost or a
// reference does not lie earlier in the file, so that there are no circles. With `all` also what is
// at hand.
std::optional<std::vector<std::uint32_t>> FrameDecoder::needed(RecordingContents& contents,
                                                               std::uint32_t frame, bool all) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> found;  // by offset in the file
  std::vector<std::uint32_t> open = {frame};
  std::unordered_set<std::uint32_t> seen = {frame};
  while (!open.empty()) {
    const std::uint32_t next = open.back();
    open.pop_back();
    const IndexedFrame* known = contents.find(next);
    if (known == nullptr || undecodable_.contains(next)) return std::nullopt;
    if (Slot* slot = all ? nullptr : at_hand(next)) {
      slot->last_use = ++uses_;
      continue;
    }
    const auto [offset, references] = std::pair(known->offset, known->references);
    found.emplace_back(offset, next);
    if (found.size() > most_needed + 1) return std::nullopt;
    for (const std::uint32_t reference : references) {
      const IndexedFrame* referred = contents.find(reference);  // from here on `known` may be gone
      if (referred == nullptr || referred->offset >= offset) return std::nullopt;
      if (seen.insert(reference).second) open.push_back(reference);
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<std::uint32_t> frames;
  frames.reserve(found.size());
  for (const auto& [offset, number] : found) frames.push_back(number);
  return frames;
}

bool FrameDecoder::is_readable(RecordingContents& contents, std::uint32_t frame) {
  return needed(contents, frame, true).has_value();
}

const QuantisedFrame* FrameDecoder::decode(RecordingContents& contents, std::uint32_t frame) {
  begin_of_call_ = ++uses_;
  if (slots_.size() > slots_kept) slots_.resize(slots_kept);
  const auto frames = needed(contents, frame, false);
  if (!frames) return nullptr;
  for (const std::uint32_t next : *frames)
    if (!decode_one(contents, next)) return nullptr;
  Slot* slot = at_hand(frame);
  slot->last_use = ++uses_;
  return &slot->quantised;
}

// One that this call does not need: the one that has not been used for longest, or a new one.
FrameDecoder::Slot& FrameDecoder::free_slot() {
  if (slots_.size() >= slots_kept) {
    const auto oldest =
        std::min_element(slots_.begin(), slots_.end(),
                         [](const auto& a, const auto& b) { return a->last_use < b->last_use; });
    if ((*oldest)->last_use < begin_of_call_) return **oldest;
  }
  return *slots_.emplace_back(std::make_unique<Slot>());
}

bool FrameDecoder::decode_one(RecordingContents& contents, std::uint32_t frame) {
  const IndexedFrame* entry = contents.find(frame);
  if (entry == nullptr) return false;
  Slot& slot = free_slot();
  slot.last_use = 0;
  if (decode_record(contents, *entry, slot)) {
    slot.frame = frame;
    slot.last_use = ++uses_;
    return true;
  }
  // What the directory promised may be elsewhere; what was found by walking is there for good.
  if (contents.is_checked()) undecodable_.insert(frame);
  return false;
}

bool FrameDecoder::decode_record(const RecordingContents& contents, const IndexedFrame& entry,
                                 Slot& slot) {
  const std::string bytes = contents.file().read(entry.offset, entry.record_bytes);
  const auto payload = whole_record(bytes, RecordType::frame);
  if (!payload) return false;
  const auto record = parse_frame_payload(*payload);
  if (!record || record->recording_id != contents.start().recording_id ||
      record->frame != entry.frame || record->references != entry.references)
    return false;
  const auto references = frames_of(entry.references, [this](std::uint32_t reference) {
    Slot* decoded = at_hand(reference);
    if (decoded != nullptr) decoded->last_use = ++uses_;
    return decoded == nullptr ? nullptr : &decoded->quantised;
  });
  // Where the contents were checked meanwhile, the frame may refer to others than before.
  if (std::find(references.begin(), references.end(), nullptr) != references.end()) return false;
  return decoder_.decode(record->encoding, record->geometry, references, slot.quantised);
}

}  // namespace ribbon
