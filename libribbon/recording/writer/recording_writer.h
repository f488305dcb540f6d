// Writes a recording frame by frame.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "recording/codec/position_encoder.h"
#include "recording/codec/quantised_frame.h"
#include "recording/records/directory_record.h"
#include "recording/records/frame_record.h"
#include "recording/records/record_head.h"
#include "recording/records/recording.h"
#include "recording/writer/record_file.h"
#include "result/result.h"

namespace ribbon {

// Frames come in groups of so many, the first of which is a key frame. Longer groups are smaller
// and slower to seek in.
inline constexpr std::uint32_t group_frames = 20;

// What a frame is predicted from: the one before it in its group. Numbers are from 0.
inline std::optional<std::uint32_t> reference_of(std::uint32_t frame) {
  return frame % group_frames == 0 ? std::nullopt : std::optional(frame - 1);
}

// A frame as it will be decoded.
struct DecodedFrame {
  std::uint32_t frame = 0;  // from 0
  QuantisedFrame quantised;
};

// What a writer must know of a recording to go on with it, and keeps up to date.
struct RecordedSoFar {
  RecordingHeader header;
  std::uint32_t recording_id = 0;
  std::uint32_t frames = 0;                 // one more than the highest frame number
  std::vector<IndexLocation> indices = {};  // the index records that are there
  Index not_indexed = {};                   // what lies in the file and in none of them
  // What the next frame may be predicted from, where it is at hand.
  std::optional<DecodedFrame> last = std::nullopt;
};

// Wall time that a writer has taken so far.
struct WriterFigures {
  double encoding_s = 0;
  double writing_s = 0;
  double syncing_s = 0;
};

class RecordingWriter {
 public:
  // Creates `path` as RecordFile::create() does and writes the header at once, so that an
  // unwritable target is known before a long run. The file stays locked as long as the writer
  // lives. An older file stays until the first frame is written; with Overwrite::when_told until
  // take_place() or finish().
  static Result<RecordingWriter> create(const std::filesystem::path& path,
                                        const RecordingHeader& header,
                                        Overwrite overwrite = Overwrite::yes);

  // Goes on with a recording that `file` ends with; resume_recording() finds out what there is.
  RecordingWriter(RecordFile file, RecordedSoFar so_far);

  // All of these hand what they append to the operating system before they return. They fail on a
  // write error; what was written before stays readable, and the remedy says how much that is.

  // The next frame. positions: 3 x particles in metres. Fails as well where they cannot be encoded
  // within the bound, and can then be called again.
  Result<void> append(const FrameNumbers& numbers, const Eigen::Matrix3Xd& positions);
  // The next frame as it was decoded from a recording with the same quantisation step.
  Result<void> append(const FrameNumbers& numbers, QuantisedFrame quantised);

  // A frame of any number that was encoded by others; its reference was appended before. The
  // recording id is that of this recording whatever `frame` says.
  Result<void> append_encoded(FrameRecord frame);

  // The simulation's state just after the frame appended last (there must be one), and how many
  // steps led to it. Fails as well where the state is too large for a checkpoint.
  Result<void> append_checkpoint(std::uint64_t steps, std::string_view state);

  // The run is taken up again with the next frame.
  Result<void> append_session(const SessionNote& note);

  // The recording takes the place of an older file of its name.
  Result<void> take_place() { return file_.take_place(); }

  // Nothing of it is of use, as of one that has not taken its place: the name is free again, or the
  // older file's. Nothing may be written afterwards.
  void take_back() { file_.take_back(); }

  // Waits until all that was appended is on the disk.
  Result<void> sync();

  // Writes the last index and what ended the run, syncs and closes. Without it the recording is
  // still complete: readers then scan. Without a frame an older file stays, as told at create().
  Result<void> finish(RunEnding ending = RunEnding::unknown);

  // Where to read what has been written so far.
  [[nodiscard]] const std::filesystem::path& present_path() const { return file_.present_path(); }
  [[nodiscard]] const RecordingHeader& header() const { return so_far_.header; }
  [[nodiscard]] std::uint32_t recording_id() const { return so_far_.recording_id; }
  [[nodiscard]] std::uint64_t bytes_written() const { return file_.size(); }  // the file's size
  // Since the recording began, lost ones included.
  [[nodiscard]] std::uint32_t frames_written() const { return so_far_.frames; }
  [[nodiscard]] WriterFigures figures() const { return figures_; }

 private:
  Result<void> write(std::string_view records);
  Result<void> write_index();
  Result<void> write_other(RecordType type, std::uint32_t frame, std::string_view payload);

  RecordFile file_;
  bool waits_ = false;  // until it is told to take its place
  RecordedSoFar so_far_;
  std::uint32_t last_frame_ = 0;     // appended last
  std::uint32_t synced_frames_ = 0;  // how many are known to be on the disk
  PositionEncoder encoder_;
  WriterFigures figures_;
};

}  // namespace ribbon
