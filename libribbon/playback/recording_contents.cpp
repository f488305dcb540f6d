#include "playback/recording_contents.h"

#include <algorithm>
#include <string>
#include <utility>

#include "recording/records/checkpoint_record.h"
#include "recording/records/frame_record.h"
#include "recording/records/record_head.h"
#include "recording/records/session_record.h"

namespace ribbon {

namespace {

constexpr const char* foreign = "a record does not belong here";

}  // namespace

RecordingContents::RecordingContents(OpenedRecording recording)
    : file_(std::move(recording.file)), start_(std::move(recording.start)) {
  start_over();
  if (!trust_directory()) check();
}

void RecordingContents::start_over() {
  table_ = {};
  others_.clear();
  indices_.clear();
  index_is_loaded_.clear();
  page_is_loaded_.clear();
  damage_.clear();
  if (!start_.signature_is_right)
    damage_.push_back({0, file_signature.size(), "the file's signature is wrong"});
  end_ = start_.end;
  lost_in_tail_ = 0;
  finished_ = false;
  ending_ = RunEnding::unknown;
}

std::optional<std::string> RecordingContents::payload_at(const RecordPlace& place) const {
  return read_payload(file_, start_.header.grid, place);
}

// At most: what lies behind may be among it.
std::uint64_t RecordingContents::written_before(std::uint64_t offset) const {
  return std::min(offset, file_.written_bytes());
}

std::uint64_t RecordingContents::most_frames_before(std::uint64_t offset) const {
  return most_frames(written_before(offset));
}

bool RecordingContents::trust_directory() {
  constexpr std::uint64_t footer_bytes = record_head_bytes + footer_payload_bytes;
  if (file_.size() < start_.end + footer_bytes) return false;
  const std::uint64_t footer_at = file_.size() - footer_bytes;
  const auto footer_payload = payload_at({RecordType::footer, footer_at, footer_bytes});
  if (!footer_payload) return false;
  const auto directory_at = parse_footer_payload(*footer_payload, start_.recording_id);
  if (!directory_at || *directory_at < start_.end || *directory_at > footer_at) return false;
  const auto payload =
      payload_at({RecordType::directory, *directory_at, footer_at - *directory_at});
  if (!payload) return false;
  auto directory = parse_directory_payload(*payload, start_.recording_id, *directory_at,
                                           written_before(*directory_at));
  if (!directory) return false;
  table_.extend(directory->frames);
  indices_ = std::move(directory->indices);
  index_is_loaded_.resize(indices_.size());
  page_is_loaded_.resize(directory->frames / FrameTable::page_frames + 1);
  ending_ = directory->ending;
  finished_ = true;
  end_ = file_.size();
  return true;
}

std::optional<Index> RecordingContents::read_index(const IndexLocation& location) const {
  const auto payload = payload_at({RecordType::index, location.offset, location.record_bytes});
  if (!payload) return std::nullopt;
  auto index = parse_index_payload(*payload, start_.recording_id, location.offset,
                                   written_before(location.offset));
  if (!index || index->frames.size() != location.frames || index->others.size() != location.others)
    return std::nullopt;
  return index;
}

// False where the index record is not what the directory promised.
bool RecordingContents::load(std::size_t index) {
  if (index_is_loaded_[index]) return true;
  const auto read = read_index(indices_[index]);
  if (!read) return false;
  for (const IndexedFrame& frame : read->frames)
    if (frame.frame < indices_[index].lowest_frame || frame.frame > indices_[index].highest_frame ||
        !table_.insert(frame))
      return false;
  others_.insert(others_.end(), read->others.begin(), read->others.end());
  index_is_loaded_[index] = true;
  return true;
}

// All that the indices tell of the frames in the same page of the table.
void RecordingContents::load_around(std::uint32_t frame) {
  const std::uint32_t page = frame / FrameTable::page_frames;
  if (checked_ || page >= page_is_loaded_.size() || page_is_loaded_[page]) return;
  for (std::size_t i = 0; i < indices_.size(); ++i) {
    const bool overlaps = indices_[i].frames > 0 &&
                          indices_[i].lowest_frame / FrameTable::page_frames <= page &&
                          indices_[i].highest_frame / FrameTable::page_frames >= page;
    if (overlaps && !load(i)) return check();
  }
  page_is_loaded_[page] = true;
}

const IndexedFrame* RecordingContents::find(std::uint32_t frame) {
  load_around(frame);
  return table_.find(frame);
}

const std::vector<IndexedOther>& RecordingContents::others() {
  for (std::size_t i = 0; !checked_ && i < indices_.size(); ++i)
    if (indices_[i].others > 0 && !load(i)) check();
  std::sort(others_.begin(), others_.end(),
            [](const IndexedOther& a, const IndexedOther& b) { return a.offset < b.offset; });
  return others_;
}

void RecordingContents::check() {
  if (std::exchange(checked_, true)) return;
  // What the directory promised stays, so that lost frames at the end still count.
  const std::uint32_t promised = table_.size();
  start_over();
  table_.extend(promised);
  walk();
}

bool RecordingContents::refresh() {
  if (!file_.update_size()) return true;
  if (file_.size() < end_) return false;
  walk();
  return true;
}

void RecordingContents::walk() {
  // Behind the last whole record something else may stand by now.
  std::erase_if(damage_, [this](const Damage& part) { return part.byte >= end_; });
  lost_in_tail_ = 0;
  const bool was_checked = checked_;
  RecordWalk walk(file_, start_.header.grid, end_);
  for (WalkStep step = walk.next(); step.kind != WalkStep::Kind::end; step = walk.next()) {
    const bool is_record = step.kind == WalkStep::Kind::record;
    const char* problem = is_record ? take(step) : step.reason;
    if (checked_ != was_checked) return;  // an index was wrong, and all has been walked through
    if (problem != nullptr) {
      damage_.push_back({step.offset, step.length, problem});
      if (!is_record && step.head_is_whole && step.type == RecordType::frame &&
          frame_count() < most_frames_before(step.offset))
        ++lost_in_tail_;
      continue;
    }
    end_ = step.offset + step.length;
    lost_in_tail_ = 0;
  }
}

// Nothing, or what is wrong with it.
const char* RecordingContents::take(const WalkStep& step) {
  switch (step.type) {
    case RecordType::header:
      return foreign;
    case RecordType::frame:
      return take_frame(step);
    case RecordType::index:
      return take_index(step);
    case RecordType::footer:
      return take_footer(step);
    case RecordType::checkpoint:
      return take_checkpoint(step);
    case RecordType::session:
      return take_session(step);
    case RecordType::directory:
      return take_directory(step);
  }
  return nullptr;  // of a later version
}

const char* RecordingContents::take_frame(const WalkStep& step) {
  const auto record = parse_frame_payload(step.payload);
  if (!record || record->recording_id != start_.recording_id ||
      record->frame >= most_frames_before(step.offset))
    return foreign;
  const IndexedFrame frame{record->frame, static_cast<std::uint32_t>(step.length), step.offset,
                           record->reference, record->numbers};
  const bool was_checked = checked_;
  const IndexedFrame* found = find(record->frame);
  const auto known = found == nullptr ? std::nullopt : std::optional(*found);
  // Of two, one is a copy over something else, and not where it was written.
  const bool is_foreign =
      known && (lies_behind_its_reference(*known) || !lies_behind_its_reference(frame));
  if (checked_ != was_checked) return nullptr;  // this record has been taken as well, on the way
  if (is_foreign) return foreign;
  if (known)
    table_.replace(frame);
  else
    table_.insert(frame);
  finished_ = false;
  ending_ = RunEnding::unknown;
  return nullptr;
}

bool RecordingContents::lies_behind_its_reference(const IndexedFrame& frame) {
  if (!frame.reference) return true;
  const IndexedFrame* reference = find(*frame.reference);
  return reference != nullptr && reference->offset < frame.offset;
}

// An index also tells of frames that are lost.
const char* RecordingContents::take_index(const WalkStep& step) {
  const auto index = parse_index_payload(step.payload, start_.recording_id, step.offset,
                                         written_before(step.offset));
  if (!index) return foreign;
  indices_.push_back(location_of(*index, step.offset, static_cast<std::uint32_t>(step.length)));
  index_is_loaded_.push_back(true);
  if (!index->frames.empty()) table_.extend(indices_.back().highest_frame + 1);
  return nullptr;
}

const char* RecordingContents::take_directory(const WalkStep& step) {
  const auto directory = parse_directory_payload(step.payload, start_.recording_id, step.offset,
                                                 written_before(step.offset));
  if (!directory) return foreign;
  table_.extend(directory->frames);
  ending_ = directory->ending;
  finished_ = true;
  return nullptr;
}

const char* RecordingContents::take_footer(const WalkStep& step) {
  if (!parse_footer_payload(step.payload, start_.recording_id)) return foreign;
  finished_ = true;
  return nullptr;
}

const char* RecordingContents::take_checkpoint(const WalkStep& step) {
  const auto fields = parse_checkpoint_fields(step.payload);
  if (!fields || fields->recording_id != start_.recording_id ||
      fields->frame >= most_frames_before(step.offset))
    return foreign;
  return take_other(step, fields->frame, fields->frame + 1);
}

const char* RecordingContents::take_session(const WalkStep& step) {
  const auto session = parse_session_payload(step.payload, start_.recording_id);
  if (!session || session->first_frame > most_frames_before(step.offset)) return foreign;
  return take_other(step, session->first_frame, session->first_frame);
}

// `frames`: so many there must have been before it.
const char* RecordingContents::take_other(const WalkStep& step, std::uint32_t frame,
                                          std::uint32_t frames) {
  others_.push_back({step.type, frame, step.offset, step.length});
  table_.extend(frames);
  finished_ = false;
  ending_ = RunEnding::unknown;
  return nullptr;
}

}  // namespace ribbon
