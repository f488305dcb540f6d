#include "recording/writer/background_writer.h"

#include <utility>

namespace ribbon {

void BackgroundWriter::note(Result<void> outcome) {
  const std::lock_guard lock(mutex_);
  if (problem_ && !outcome) problem_ = std::move(outcome);
  figures_.writer = writer_.figures();
  bytes_ = writer_.bytes_written();
}

void BackgroundWriter::append(const FrameNumbers& numbers, const Eigen::Matrix3Xd& positions) {
  add([numbers, positions](RecordingWriter& writer) { return writer.append(numbers, positions); });
}

void BackgroundWriter::append_checkpoint(std::uint64_t steps, std::string state) {
  add([steps, state = std::move(state)](RecordingWriter& writer) {
    return writer.append_checkpoint(steps, state);
  });
}

void BackgroundWriter::append_session(const SessionNote& note) {
  add([note](RecordingWriter& writer) { return writer.append_session(note); });
}

Result<void> BackgroundWriter::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

Result<void> BackgroundWriter::finish(RunEnding ending) {
  end();
  if (!problem_) return problem_;
  note(writer_.finish(ending));
  return problem_;
}

BackgroundFigures BackgroundWriter::figures() const {
  const std::lock_guard lock(mutex_);
  return figures_;
}

std::uint64_t BackgroundWriter::bytes_written() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

}  // namespace ribbon
