// Reads a recording, any frame at any time, also while it is being written.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "playback/damage.h"
#include "playback/frame_decoder.h"
#include "playback/recording_contents.h"
#include "recording/codec/quantised_frame.h"
#include "recording/records/recording.h"
#include "result/result.h"

namespace ribbon {

// Loads what it needs when it is asked, also in questions that are const: give each thread its own
// reader.
class RecordingReader {
 public:
  // Opens `path` and finds its frames, by the directory where there is one and by walking through
  // the file otherwise. A cut-off tail is a normal end. Fails when the file cannot be read or its
  // header is not valid.
  static Result<RecordingReader> open(const std::filesystem::path& path);

  [[nodiscard]] const RecordingHeader& header() const;
  [[nodiscard]] std::uint32_t recording_id() const;
  // Number of frames recorded, lost ones included, so that a frame keeps its index whatever
  // happened to its neighbours. Indices run from 0; users see frames numbered from 1.
  [[nodiscard]] int frame_count() const;
  // Can frame `index` be decoded? False where damage took it or a frame that it builds upon.
  [[nodiscard]] bool readable(int index) const;
  // The numbers of frame `index`, read without its geometry; nothing where its record is lost.
  [[nodiscard]] std::optional<FrameNumbers> numbers(int index) const;
  // Was the recording finished, or was its writer stopped on the way?
  [[nodiscard]] bool finished() const;
  // What ended the run; unknown where the recording is not finished or its writer did not tell.
  [[nodiscard]] RunEnding ending() const;
  // What is known to be damaged. A directory tells nothing about the frames that it leads to, so
  // damage to frames of a finished recording is noticed when one of them is read, or by check().
  [[nodiscard]] const std::vector<Damage>& damage() const;
  [[nodiscard]] std::uint64_t file_bytes() const;

  // The frames (from 0) that checkpoints belong to, in the order of the file.
  [[nodiscard]] std::vector<std::uint32_t> checkpoints() const;
  // The last checkpoint of a frame. Fails where there is none or it is damaged.
  [[nodiscard]] Result<Checkpoint> read_checkpoint(std::uint32_t frame) const;
  // Where the run was taken up again, in the order of the file; damaged ones are left out.
  [[nodiscard]] std::vector<Session> sessions() const;

  // Is a writer at it at this moment?
  [[nodiscard]] bool is_being_written() const;

  // Finds out what a growing file has gained, at a cost of that alone. Fails where the file has
  // become shorter than what was read of it: it is another recording now.
  Result<void> refresh();

  // Reads every record and compares its checksum, so that readable(), numbers() and damage() tell
  // all. Takes the time to read the file once; frames are not decoded.
  void check();

  // Decodes frame `index` into `positions` (resized to 3 x particles, metres, single precision).
  // The answer is the same whatever was read before. Cheapest in ascending order, in which every
  // frame is decoded once. Fails when the frame is not readable.
  Result<void> read(int index, Eigen::Matrix3Xf& positions);

  // The same frame as other frames are predicted from it. Valid until the next call.
  Result<const QuantisedFrame*> read_quantised(int index);

 private:
  RecordingReader(std::filesystem::path path, OpenedRecording recording);
  [[nodiscard]] std::optional<std::string> payload_of(const IndexedOther& other) const;
  template <class Question>
  auto surely(Question question) const;

  std::filesystem::path path_;
  mutable RecordingContents contents_;
  mutable FrameDecoder decoder_;
};

}  // namespace ribbon
