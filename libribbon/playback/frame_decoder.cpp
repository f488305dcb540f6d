#include "playback/frame_decoder.h"

#include <algorithm>
#include <limits>

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

// The frame and the chain of those that it needs, in the order in which to decode them; nothing
// where one is lost or does not lie earlier in the file, so that there are no circles. With `all`
// also what is at hand.
std::optional<std::vector<std::uint32_t>> FrameDecoder::needed(RecordingContents& contents,
                                                               std::uint32_t frame, bool all) {
  std::vector<std::uint32_t> chain;
  std::uint64_t offset = std::numeric_limits<std::uint64_t>::max();
  for (std::optional<std::uint32_t> next = frame; next;) {
    const IndexedFrame* known = contents.find(*next);
    if (known == nullptr || known->offset >= offset || undecodable_.contains(*next))
      return std::nullopt;
    if (Slot* slot = all ? nullptr : at_hand(*next)) {
      if (chain.size() + slot->needs > most_needed) return std::nullopt;
      slot->last_use = ++uses_;
      break;
    }
    if (chain.size() > most_needed) return std::nullopt;
    chain.push_back(*next);
    offset = known->offset;
    next = known->reference;
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

bool FrameDecoder::is_readable(RecordingContents& contents, std::uint32_t frame) {
  return needed(contents, frame, true).has_value();
}

const QuantisedFrame* FrameDecoder::decode(RecordingContents& contents, std::uint32_t frame) {
  const auto frames = needed(contents, frame, false);
  if (!frames) return nullptr;
  for (const std::uint32_t next : *frames)
    if (!decode_one(contents, next)) return nullptr;
  Slot* slot = at_hand(frame);
  slot->last_use = ++uses_;
  return &slot->quantised;
}

// A new one, or the one that has not been used for longest: never the reference of the frame that
// comes next, which was used last.
FrameDecoder::Slot& FrameDecoder::free_slot() {
  if (slots_.size() < slots_kept) return *slots_.emplace_back(std::make_unique<Slot>());
  return **std::min_element(slots_.begin(), slots_.end(),
                            [](const auto& a, const auto& b) { return a->last_use < b->last_use; });
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
  const auto payload = contents.payload_at({RecordType::frame, entry.offset, entry.record_bytes});
  if (!payload) return false;
  const auto record = parse_frame_payload(*payload);
  if (!record || record->recording_id != contents.start().recording_id ||
      record->frame != entry.frame || record->reference != entry.reference)
    return false;
  Slot* reference = nullptr;
  slot.needs = 0;
  if (entry.reference) {
    reference = at_hand(*entry.reference);
    // Where the contents were checked meanwhile, the frame may refer to another than before.
    if (reference == nullptr) return false;
    slot.needs = reference->needs + 1;
  }
  return decoder_.decode(record->encoding, record->geometry,
                         reference == nullptr ? nullptr : &reference->quantised, slot.quantised);
}

}  // namespace ribbon
