// For WebAssembly, which has no threads here: BackgroundWriter writes during the call.
#include <utility>

#include "recording/writer/background_writer.h"

namespace ribbon {

BackgroundWriter::BackgroundWriter(RecordingWriter writer)
    : writer_(std::move(writer)), bytes_(writer_.bytes_written()) {}

BackgroundWriter::~BackgroundWriter() = default;

void BackgroundWriter::add(Task task, Clock::time_point called) {
  if (problem_) note(task(writer_));
  figures_.blocked_s += std::chrono::duration<double>(Clock::now() - called).count();
}

void BackgroundWriter::end() {}

}  // namespace ribbon
