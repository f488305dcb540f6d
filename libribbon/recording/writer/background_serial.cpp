// For WebAssembly, which has no threads here: BackgroundWriter writes during the call.
#include <utility>

#include "recording/writer/background_writer.h"

namespace ribbon {

BackgroundWriter::BackgroundWriter(RecordingWriter writer)
    : writer_(std::move(writer)), bytes_(writer_.bytes_written()) {}

BackgroundWriter::~BackgroundWriter() = default;

void BackgroundWriter::add(Task task) {
  if (problem_) note(task(writer_));
}

void BackgroundWriter::end() {}

}  // namespace ribbon
