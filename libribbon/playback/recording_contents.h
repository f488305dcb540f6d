// What a recording holds and where it lies: told by its directory, or found by walking through it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playback/damage.h"
#include "playback/frame_table.h"
#include "playback/random_access_file.h"
#include "playback/record_walk.h"
#include "playback/recording_start.h"
#include "recording/records/directory_record.h"
#include "recording/records/recording.h"

namespace ribbon {

class RecordingContents {
 public:
  // Trusts the directory where there is one and loads index records as they are needed; walks
  // through the file otherwise.
  explicit RecordingContents(OpenedRecording recording);

  [[nodiscard]] const RandomAccessFile& file() const { return file_; }
  [[nodiscard]] const RecordingStart& start() const { return start_; }
  // As read_payload().
  [[nodiscard]] std::optional<std::string> payload_at(const RecordPlace& place) const;

  // Finds out what the file has gained. False, finding out nothing, where it has become shorter
  // than what was read of it.
  bool refresh();

  // Walks through all of the file, unless that has been done: what it found counts, not what the
  // directory says.
  void check();
  [[nodiscard]] bool is_checked() const { return checked_; }

  // Frames that exist, lost ones included.
  [[nodiscard]] std::uint32_t frame_count() const { return table_.size() + lost_in_tail_; }
  // The same without those that were lost behind end().
  [[nodiscard]] std::uint32_t frames_before_end() const { return table_.size(); }

  // Nothing where the frame is lost. Valid until check() or the next call.
  const IndexedFrame* find(std::uint32_t frame);

  // Checkpoints and sessions, as they lie in the file.
  const std::vector<IndexedOther>& others();

  [[nodiscard]] const std::vector<Damage>& damage() const { return damage_; }
  [[nodiscard]] bool finished() const { return finished_; }
  [[nodiscard]] RunEnding ending() const { return ending_; }

  // Where the last whole record ends.
  [[nodiscard]] std::uint64_t end() const { return end_; }
  // The index records, and what one of them tells; nothing where that is not what was promised.
  [[nodiscard]] const std::vector<IndexLocation>& indices() const { return indices_; }
  [[nodiscard]] std::optional<Index> read_index(const IndexLocation& location) const;

 private:
  bool trust_directory();
  void start_over();
  bool load(std::size_t index);
  void load_around(std::uint32_t frame);
  [[nodiscard]] std::uint64_t written_before(std::uint64_t offset) const;
  [[nodiscard]] std::uint64_t most_frames_before(std::uint64_t offset) const;
  void walk();
  const char* take(const WalkStep& step);
  const char* take_frame(const WalkStep& step);
  bool lies_behind_its_reference(const IndexedFrame& frame);
  const char* take_index(const WalkStep& step);
  const char* take_directory(const WalkStep& step);
  const char* take_footer(const WalkStep& step);
  const char* take_checkpoint(const WalkStep& step);
  const char* take_session(const WalkStep& step);
  const char* take_other(const WalkStep& step, std::uint32_t frame, std::uint32_t frames);

  RandomAccessFile file_;
  RecordingStart start_;
  FrameTable table_;
  std::vector<IndexedOther> others_;
  std::vector<IndexLocation> indices_;
  std::vector<bool> index_is_loaded_;  // not all of them are while the directory is trusted
  std::vector<bool> page_is_loaded_;   // likewise, of the table
  std::vector<Damage> damage_;
  std::uint64_t end_ = 0;
  std::uint32_t lost_in_tail_ = 0;  // damaged frame records behind end_
  bool finished_ = false;
  RunEnding ending_ = RunEnding::unknown;
  bool checked_ = false;
};

}  // namespace ribbon
