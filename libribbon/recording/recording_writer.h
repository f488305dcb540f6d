// Writes a recording frame by frame.
#pragma once

#include <filesystem>
#include <memory>

#include "recording/recording.h"
#include "result/result.h"

namespace ribbon {

class RecordingWriter {
 public:
  // Creates `path` (replacing an older file) and writes the header at once, so that an unwritable
  // target is known before a long run. Creates missing parent folders.
  static Result<RecordingWriter> create(const std::filesystem::path& path,
                                        const RecordingHeader& header);

  RecordingWriter(RecordingWriter&&) noexcept;
  RecordingWriter& operator=(RecordingWriter&&) noexcept;
  ~RecordingWriter();

  // Appends one frame and hands it to the operating system before returning. positions: 3 x
  // particles in metres. Either all frames have a tightness or none. Fails on a write error; all
  // earlier frames stay readable.
  Result<void> append(const FrameNumbers& numbers, const Eigen::Matrix3Xd& positions);

  // Writes the seek index and what ended the run, and closes. Without it the recording is still
  // complete: readers then scan.
  Result<void> finish(RunEnding ending = RunEnding::unknown);

  [[nodiscard]] std::uint64_t bytes_written() const;
  [[nodiscard]] std::uint32_t frames_written() const;

 private:
  struct State;
  explicit RecordingWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace ribbon
