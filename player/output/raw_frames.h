// Pictures as bare pixels on standard output, for other programs.
#pragma once

#include <memory>
#include <utility>

#include "files/descriptor.h"
#include "player/output/picture_sink.h"

namespace ribbon {

// Three bytes a pixel (rgb24), row by row from the top left, nothing before, between and after.
class RawFrames final : public PictureSink {
 public:
  // Fails where standard output is a terminal.
  static Result<std::unique_ptr<PictureSink>> open();

  Result<void> put(OutputPicture picture) override;
  Result<void> finish() override;

 private:
  explicit RawFrames(FileDescriptor output) : output_(std::move(output)) {}

  FileDescriptor output_;
};

}  // namespace ribbon
