// Pictures as bare pixels on standard output, for other programs.
#pragma once

#include <memory>
#include <utility>

#include "files/descriptor.h"
#include "player/output/picture_sink.h"
#include "player/output/reader_pipe.h"

namespace ribbon {

// Three bytes a pixel (rgb24), row by row from the top left, nothing before, between and after.
class RawFrames final : public PictureSink {
 public:
  // Fails where standard output is a terminal.
  static Result<std::unique_ptr<PictureSink>> open(Stopped stopped);

  // Fails, too, where it was stopped and nobody reads.
  Result<void> put(OutputPicture picture) override;
  Result<void> finish() override;

 private:
  RawFrames(FileDescriptor output, Stopped stopped)
      : output_(std::move(output)), stopped_(std::move(stopped)) {}

  FileDescriptor output_;
  Stopped stopped_;
};

}  // namespace ribbon
